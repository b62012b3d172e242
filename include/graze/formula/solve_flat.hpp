// graze::solve for a ball and a bounded wall or a triangle.
#pragma once

#include <graze/formula/flat_encounter.hpp>
#include <graze/formula/solve_plane.hpp>

namespace graze::inline v0_1 {

namespace detail {

template <int N, class T>
[[nodiscard]] constexpr flat_motion<N, T> flat_motion_of(const ball<N, T>& b, const wall<N, T>& w) {
    return {b.position - w.corner, b.velocity, w.edge, b.radius, false};
}
template <class T>
[[nodiscard]] constexpr flat_motion<3, T> flat_motion_of(const ball<3, T>& b, const triangle<T>& t) {
    return {b.position - t.corner, b.velocity, t.edge, b.radius, true};
}

// Answers the questions of flat_decision in T. A discriminant, and the numbers of a time, are those of the quadratic
// from which the time is computed, by a variant. The variant is no parameter of the template: it makes a few operations
// of many.
template <int N, class T>
class direct_judge {
  public:
    static constexpr bool has_roots = has_sqrt<T>;

    constexpr explicit direct_judge(const flat_motion<N, T>& m, variant v = variant::lagrange)
        : motion_{m.w, m.u, m.e, m.r}, is_triangle_(m.is_triangle), variant_(v) {}

    [[nodiscard]] constexpr bool root(const T& x, T& y) const {
        y = graze::square_root(graze::sign(x) < 0 ? T(0) : x);
        return true;
    }
    template <class F, class X>
    [[nodiscard]] constexpr int operator()(F f, const X& x) const {
        return graze::sign(T(f(x)));
    }
    [[nodiscard]] constexpr int operator()(border_h, const flat_edge<N, T>& x) const {
        return graze::sign(edge(x).q.h);
    }
    [[nodiscard]] constexpr int operator()(border_c, const flat_edge<N, T>& x) const {
        return graze::sign(edge(x).q.c);
    }
    [[nodiscard]] constexpr int operator()(border_discriminant, const flat_edge<N, T>& x) const {
        return graze::sign(edge(x).discriminant);
    }
    [[nodiscard]] constexpr int operator()(corner_discriminant, const flat_edge<N, T>& x) const {
        return graze::sign(corner(x.corner).discriminant);
    }

    struct approach {
        quadratic<T, T, T> q;
        T discriminant;
    };
    [[nodiscard]] constexpr auto view_of_edge(int index) const {
        return seen_from(motion_, edge_view(edge_number(index, is_triangle_)));
    }
    [[nodiscard]] constexpr auto view_of_corner(int index) const { return seen_from(motion_, wall_view{index, false}); }
    [[nodiscard]] constexpr approach edge(int index) const {
        const auto view = view_of_edge(index);
        const quadratic<T, T, T> q = edge_quadratic(view);
        return {q, discriminant(q, [&] { return T(edge_discriminant{}(view)); })};
    }
    [[nodiscard]] constexpr approach corner(int index) const {
        const auto m = corner_motion(view_of_corner(index));
        const quadratic<T, T, T> q = quadratic_of(m);
        return {q, discriminant(q, [&] { return T(discriminant_lagrange{}(m)); })};
    }
    // Of a feature but the face.
    [[nodiscard]] constexpr approach feature(graze::feature where, int index) const {
        if constexpr (N == 3) {
            if (where == graze::feature::edge) {
                return edge(index);
            }
        }
        return corner(index);
    }

  private:
    template <class L>
    [[nodiscard]] constexpr T discriminant(const quadratic<T, T, T>& q, L lagrange) const {
        if constexpr (field_number<T>) { // textbook's is divided
            if (variant_ == variant::textbook) {
                return discriminant_by<variant::textbook, T>(q, lagrange);
            }
        }
        if (variant_ == variant::halved) {
            return discriminant_by<variant::halved, T>(q, lagrange);
        }
        if constexpr (has_variant<variant::kahan, T>) {
            if (variant_ == variant::kahan) {
                return discriminant_by<variant::kahan, T>(q, lagrange);
            }
        }
        return lagrange();
    }
    [[nodiscard]] constexpr approach edge(const flat_edge<N, T>& x) const { return edge(x.border); }

    wall_motion<N, T, T, T, T> motion_;
    bool is_triangle_;
    variant variant_;
};

// The encounter in T, and the feature that is met or, if the ball recedes, the closest one.
template <class Judge, int N, class T>
[[nodiscard]] constexpr flat_answer decide_directly(const flat_motion<N, T>& m, const Judge& judge) {
    const auto way = way_of(m);
    const flat_decision<N, T, Judge> decision(m, way, judge);
    const flat_answer found = decision();
    return found.what == encounter::recede ? decision.with_closest(found) : found;
}

// The contact with an edge or a corner, of a solution that has its encounter, feature and time: the same by whichever
// formulas these were found.
template <int N, class T>
constexpr void set_contact(wall_solution<N, T>& s, const ball<N, T>& b, const direct_judge<N, T>& judge) {
    using real = root_type<T>;
    const vec<N, real> u = detail::as<real>(b.velocity);
    s.position = position_at(detail::as<real>(b.position), u, s.time);
    if (s.where == feature::corner) {
        s.point = detail::as<real>(b.position - judge.view_of_corner(s.index).w);
    }
    if constexpr (N == 3) {
        if (s.where == feature::edge) {
            const auto view = judge.view_of_edge(s.index);
            const vec<N, real> e = detail::as<real>(view.e[1]);
            const vec<N, real> from = position_at(detail::as<real>(view.w), u, s.time);
            s.point = position_at(s.position - from, e, graze::dot(from, e) / graze::squared_norm(e));
        }
    }
    const vec<N, real> apart = s.position - s.point;
    if (s.what == encounter::overlap) {
        if constexpr (has_sqrt<T>) {
            s.normal = contact_normal(apart, graze::root(T(graze::squared_norm(apart))));
        } else {
            s.normal = contact_normal(apart,
                                      graze::root(T(graze::squared_norm(apart).p()))); // τ = 0: rational
        }
    } else {
        s.normal = graze::sign(b.radius) != 0 ? contact_normal(apart, real(b.radius)) : detail::zero_vector<N, real>();
    }
    s.velocity = s.what == encounter::graze ? u : reflected(u, s.normal);
}

template <root_form F, int N, class T>
[[nodiscard]] constexpr wall_solution<N, T> solve_flat(const ball<N, T>& b, const vec<N, T>& corner,
                                                       const flat_motion<N, T>& m, variant v) {
    const direct_judge<N, T> judge(m, v);
    const flat_answer found = decide_directly(m, judge);
    wall_solution<N, T> s;
    if (is_collision(found.what) && found.where == feature::face) {
        s = solve(b, plane<N, T>{corner, vec<N, T>(face_normal(m.e))});
    }
    s.what = found.what;
    s.where = found.where;
    s.index = found.index;
    if (is_collision(s.what) && s.where != feature::face) {
        const auto approach = judge.feature(s.where, s.index);
        s.discriminant = approach.discriminant;
        if (s.what != encounter::overlap) {
            s.time = detail::first_root<F>(approach.q, approach.discriminant, s.what);
        }
        set_contact(s, b, judge);
    }
    return s;
}

} // namespace detail

// The whole solution in T: the feature that is met first, then time and contact, by Eq. (33) completed or by the
// quadratic of the edge or corner in variant V. Does not check its input.
template <variant V = variant::lagrange, root_form F = root_form::stable, number T, int N>
requires field_number<T> && has_variant<V, T>
[[nodiscard]] constexpr wall_solution<N, T> solve(const ball<N, T>& b, const wall<N, T>& w) {
    return detail::solve_flat<F>(b, w.corner, detail::flat_motion_of(b, w), V);
}

// The same for a triangle.
template <variant V = variant::lagrange, root_form F = root_form::stable, number T>
requires field_number<T> && has_variant<V, T>
[[nodiscard]] constexpr wall_solution<3, T> solve(const ball<3, T>& b, const triangle<T>& t) {
    return detail::solve_flat<F>(b, t.corner, detail::flat_motion_of(b, t), V);
}

} // namespace graze::inline v0_1
