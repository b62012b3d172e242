// The results of graze::solve, and the steps that all pair kinds share.
#pragma once

#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/formula/impulse.hpp>
#include <graze/formula/roots.hpp>
#include <graze/formula/wall_encounter.hpp>
#include <graze/number/sqrt_extension.hpp>

namespace graze::inline v0_1 {

// The solution of two balls in T. discriminant is D (for the textbook variant, a quarter of what it computes). time,
// positions, normal and velocities are set only if is_collision(what). They are of root_type<T>: T, or T's
// sqrt_extension if T has no square root. A graze does not change the velocities. The errors are those of T and of the
// variant; none if T is exact.
template <int N, number T>
struct ball_solution {
    using real = root_type<T>;
    encounter what{};
    T discriminant{0};
    real time{0};
    vec<N, real> position_a{}, position_b{};
    vec<N, real> normal{}; // from b to a; zero when both radii are 0
    vec<N, real> velocity_a{}, velocity_b{};
};

// The same for a ball and a plane or a wall. point is where the ball touches; the normal points from there to the ball.
template <int N, number T>
struct wall_solution {
    using real = root_type<T>;
    encounter what{};
    feature where = feature::face;
    int index = 0;     // as in wall_encounter
    T discriminant{0}; // of an edge's quadratic (a = |u × e|²) or a corner's
    real time{0};
    vec<N, real> position{}, point{}, normal{}, velocity{};
};

namespace detail {

template <class R, int N, class T>
[[nodiscard]] constexpr vec<N, R> as(const vec<N, T>& x) {
    return make_vec<N>([&](int i) { return R(x[i]); });
}

template <int N, class R>
[[nodiscard]] constexpr vec<N, R> zero_vector() {
    return make_vec<N>([](int) { return R(0); });
}

// D in variant V, from the quadratic or, for Lagrange's form, from a function that computes it.
template <variant V, class T, class L>
[[nodiscard]] constexpr T discriminant_by(const quadratic<T, T, T>& q, L lagrange) {
    if constexpr (V == variant::textbook) {
        return discriminant_textbook{}(q) / T(4);
    } else if constexpr (V == variant::halved) {
        return discriminant_halved{}(q);
    } else if constexpr (V == variant::kahan) {
        return discriminant_kahan{}(q);
    } else {
        return lagrange();
    }
}

// τ of a hit or a graze in root form F.
template <root_form F, class T>
[[nodiscard]] constexpr root_type<T> first_root(const quadratic<T, T, T>& q, const T& discriminant, encounter what) {
    using real = root_type<T>;
    if (what == encounter::graze) {
        return real(T(root_of_graze{}(q.a, q.h)));
    }
    if constexpr (F == root_form::printed) {
        return root_printed{}(real(q.a), real(T(graze::twice(q.h))),
                              graze::root(T(graze::twice(graze::twice(discriminant)))));
    } else {
        return root_stable{}(real(q.c), real(q.h), graze::root(discriminant));
    }
}

} // namespace detail
} // namespace graze::inline v0_1
