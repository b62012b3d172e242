// graze::solve for a ball and a bounded wall.
#pragma once

#include <graze/formula/solution.hpp>

namespace graze {

namespace detail {

// wall_decision's questions answered in T itself, by variant V.
template <variant V, class T, class M>
class direct_signs {
  public:
    constexpr explicit direct_signs(const M& m) : m_(m) {}

    template <class F>
    [[nodiscard]] constexpr int operator()(F f) const {
        return sign(T(f(m_)));
    }
    template <class P, class Q, class D>
    [[nodiscard]] constexpr int root(P p, Q q, D d, int flip) const {
        if constexpr (has_sqrt<T>) {
            const T radicand = d(m_);
            const T term = T(q(m_)) * square_root(sign(radicand) < 0 ? T(0) : radicand);
            return sign(flip < 0 ? T(T(p(m_)) - term) : T(T(p(m_)) + term));
        } else {
            return sign_of_root_sum(T(p(m_)), T(flip < 0 ? T(-q(m_)) : T(q(m_))), T(d(m_)));
        }
    }
    template <int I, int Far>
    [[nodiscard]] constexpr T discriminant_of_edge() const {
        return discriminant_by<V, T>(edge_quadratic<I, Far>(m_),
                                     [&] { return T(graze::edge_discriminant<I, Far>{}(m_)); });
    }
    template <int K>
    [[nodiscard]] constexpr T discriminant_of_corner() const {
        const auto corner = corner_view<K>{}.motion(m_);
        return discriminant_by<V, T>(quadratic_of(corner), [&] { return T(discriminant_lagrange{}(corner)); });
    }
    template <int I, int Far>
    [[nodiscard]] constexpr int edge_discriminant() const {
        return sign(discriminant_of_edge<I, Far>());
    }
    template <int K>
    [[nodiscard]] constexpr int corner_discriminant() const {
        return sign(discriminant_of_corner<K>());
    }

  private:
    const M& m_;
};

// Calls f with the compile-time index of an edge (I, Far) or a corner (K).
template <class F>
constexpr void with_edge(int index, F f) {
    switch (index) {
    case 0:
        f.template operator()<0, 0>();
        break;
    case 1:
        f.template operator()<0, 1>();
        break;
    case 2:
        f.template operator()<1, 0>();
        break;
    default:
        f.template operator()<1, 1>();
        break;
    }
}
template <int N, class F>
constexpr void with_corner(int index, F f) {
    if (index == 0) {
        f.template operator()<0>();
    } else if (index == 1) {
        f.template operator()<1>();
    } else if constexpr (N == 3) {
        index == 2 ? f.template operator()<2>() : f.template operator()<3>();
    }
}

} // namespace detail

// The whole solution in T: the feature that is met first, and by Eq. (33) completed or the quadratic of the edge or
// corner in variant V when and where. Does not check its input.
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
    if constexpr (N == 3) {
        if (s.where == feature::edge) {
            detail::with_edge(s.index, [&]<int I, int Far>() {
                met(edge_quadratic<I, Far>(m), signs.template discriminant_of_edge<I, Far>());
                const auto view = edge_view<I, Far>{};
                const vec<N, real> e = detail::as<real>(view.direction(m));
                const vec<N, real> from = position_at(detail::as<real>(view.offset(m)), u, s.time);
                s.point = position_at(s.position - from, e, dot(from, e) / squared_norm(e));
            });
        }
    }
    if (s.where == feature::corner) {
        detail::with_corner<N>(s.index, [&]<int K>() {
            const auto corner = corner_view<K>{}.motion(m);
            met(quadratic_of(corner), signs.template discriminant_of_corner<K>());
            s.point = detail::as<real>(b.position - corner.dx);
        });
    }
    const vec<N, real> apart = s.position - s.point;
    if (inside) {
        if constexpr (has_sqrt<T>) {
            s.normal = contact_normal(apart, root(T(squared_norm(apart))));
        } else {
            s.normal = contact_normal(apart, root(T(squared_norm(apart).p()))); // τ = 0: rational
        }
    } else {
        s.normal = sign(b.radius) != 0 ? contact_normal(apart, real(b.radius)) : detail::zero_vector<N, real>();
    }
    s.velocity = s.what == encounter::graze ? u : reflected(u, s.normal);
    return s;
}

} // namespace graze
