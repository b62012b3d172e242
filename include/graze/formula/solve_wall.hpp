// graze::solve for a ball and a bounded wall.
#pragma once

#include <graze/formula/solution.hpp>

namespace graze::inline v0_1 {

namespace detail {

// Answers the questions of wall_decision in T, by variant V.
template <variant V, class T, class M>
class direct_signs {
  public:
    constexpr explicit direct_signs(const M& m) : m_(m) {}

    template <class F>
    [[nodiscard]] constexpr int operator()(wall_view view, F f) const {
        return graze::sign(T(f(seen_from(m_, view))));
    }
    template <class P, class Q, class D>
    [[nodiscard]] constexpr int root(wall_view view, P p, Q q, D d, int flip) const {
        const auto m = seen_from(m_, view);
        if constexpr (has_sqrt<T>) {
            const T radicand = d(m);
            const T term = T(q(m)) * graze::square_root(graze::sign(radicand) < 0 ? T(0) : radicand);
            return graze::sign(flip < 0 ? T(T(p(m)) - term) : T(T(p(m)) + term));
        } else {
            return sign_of_root_sum(T(p(m)), T(flip < 0 ? T(-q(m)) : T(q(m))), T(d(m)));
        }
    }
    [[nodiscard]] constexpr T discriminant_of_edge(const M& m) const {
        return discriminant_by<V, T>(edge_quadratic(m), [&] { return T(graze::edge_discriminant{}(m)); });
    }
    [[nodiscard]] constexpr T discriminant_of_corner(const M& m) const {
        const auto corner = corner_motion(m);
        return discriminant_by<V, T>(quadratic_of(corner), [&] { return T(discriminant_lagrange{}(corner)); });
    }
    [[nodiscard]] constexpr int edge_discriminant(wall_view view) const {
        return graze::sign(discriminant_of_edge(seen_from(m_, view)));
    }
    [[nodiscard]] constexpr int corner_discriminant(wall_view view) const {
        return graze::sign(discriminant_of_corner(seen_from(m_, view)));
    }

  private:
    const M& m_;
};

} // namespace detail

// The whole solution in T: the feature that is met first, then time and contact, by Eq. (33) completed or by the
// quadratic of the edge or corner in variant V. Does not check its input.
template <variant V = variant::lagrange, root_form F = root_form::stable, number T, int N>
requires field_number<T> && has_variant<V, T>
[[nodiscard]] constexpr wall_solution<N, T> solve(const ball<N, T>& b, const wall<N, T>& w) {
    using real = root_type<T>;
    wall_solution<N, T> s;
    const auto m = relative_motion_of(b, w);
    detail::direct_signs<V, T, std::remove_cvref_t<decltype(m)>> signs(m);
    const wall_encounter found = wall_decision<N, decltype(signs)>(signs)();
    s.what = found.what;
    s.where = found.where;
    s.index = found.index;
    if (!is_collision(s.what)) {
        return s;
    }
    const bool inside = s.what == encounter::overlap;
    const vec<N, real> u = detail::as<real>(b.velocity);
    if (s.where == feature::face) {
        const wall_solution<N, T> face = solve<V, F>(b, plane<N, T>{w.corner, m.n});
        s.time = face.time;
        s.position = face.position;
        s.point = face.point;
        s.normal = face.normal;
        s.velocity = face.velocity;
        return s;
    }
    const auto met = [&](const quadratic<T, T, T>& q, const T& discriminant) {
        s.discriminant = discriminant;
        if (!inside) {
            s.time = detail::first_root<F>(q, discriminant, s.what);
        }
        s.position = position_at(detail::as<real>(b.position), u, s.time);
    };
    const auto view = seen_from(m, s.where == feature::edge ? edge_view(s.index) : wall_view{s.index, false});
    if (s.where == feature::corner) {
        met(quadratic_of(corner_motion(view)), signs.discriminant_of_corner(view));
        s.point = detail::as<real>(b.position - view.w);
    }
    if constexpr (N == 3) {
        if (s.where == feature::edge) {
            met(edge_quadratic(view), signs.discriminant_of_edge(view));
            const vec<N, real> e = detail::as<real>(view.e[1]);
            const vec<N, real> from = position_at(detail::as<real>(view.w), u, s.time);
            s.point = position_at(s.position - from, e, graze::dot(from, e) / graze::squared_norm(e));
        }
    }
    const vec<N, real> apart = s.position - s.point;
    if (inside) {
        if constexpr (has_sqrt<T>) {
            s.normal = contact_normal(apart, graze::root(T(graze::squared_norm(apart))));
        } else {
            s.normal = contact_normal(apart, graze::root(T(graze::squared_norm(apart).p()))); // τ = 0: rational
        }
    } else {
        s.normal = graze::sign(b.radius) != 0 ? contact_normal(apart, real(b.radius)) : detail::zero_vector<N, real>();
    }
    s.velocity = s.what == encounter::graze ? u : reflected(u, s.normal);
    return s;
}

} // namespace graze::inline v0_1
