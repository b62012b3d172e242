// graze::solve for two balls: the whole solution in T, by the formulas as they are.
#pragma once

#include <graze/formula/solution.hpp>

namespace graze::inline v0_1 {

namespace detail {

// The contact, of a solution that has its encounter and time: the same by whichever formulas these were found.
template <int N, class T, class Motion>
constexpr void set_contact(ball_solution<N, T>& s, const ball<N, T>& a, const ball<N, T>& b, const T& inverse_a,
                           const T& inverse_b, const Motion& m) {
    using real = root_type<T>;
    s.position_a = position_at(as<real>(a.position), as<real>(a.velocity), s.time); // (13)
    s.position_b = position_at(as<real>(b.position), as<real>(b.velocity), s.time);
    const bool touches = graze::sign(m.R) != 0;
    if (s.what == encounter::overlap) {
        s.normal = contact_normal(as<real>(m.dx), graze::root(T(graze::squared_norm(m.dx))));
    } else if (touches) {
        const vec<N, real> dx = position_at(as<real>(m.dx), as<real>(m.du), s.time);
        s.normal = contact_normal(dx, real(m.R)); // (20)
    } else {
        s.normal = zero_vector<N, real>();
    }
    s.velocity_a = as<real>(a.velocity);
    s.velocity_b = as<real>(b.velocity);
    if (s.what != encounter::graze) {
        const real mu(T(reduced_mass(inverse_a, inverse_b)));                          // (28)
        const real alpha = impulse(mu, s.normal, as<real>(m.du));                      // (29)
        s.velocity_a = velocity_after(s.velocity_a, alpha, real(inverse_a), s.normal); // (23)
        s.velocity_b = velocity_after(s.velocity_b, real(-alpha), real(inverse_b), s.normal);
    }
}

// discriminant: from the motion and its quadratic.
template <root_form F, class T, int N, class D>
[[nodiscard]] constexpr ball_solution<N, T> solve_balls(const ball<N, T>& a, const ball<N, T>& b, const T& inverse_a,
                                                        const T& inverse_b, D discriminant) {
    ball_solution<N, T> s;
    const auto m = relative_motion_of(a, b);
    const quadratic<T, T, T> q = quadratic_of(m);
    s.discriminant = discriminant(m, q);
    s.what = encounter_of([&] { return graze::sign(q.h); }, [&] { return graze::sign(q.c); },
                          [&] { return graze::sign(s.discriminant); });
    if (is_collision(s.what)) {
        if (s.what != encounter::overlap) {
            s.time = first_root<F>(q, s.discriminant, s.what);
        }
        set_contact(s, a, b, inverse_a, inverse_b, m);
    }
    return s;
}

} // namespace detail

// The same as solve, with the inverses of the masses given. 0 is an infinite mass; at most one of them may be 0.
template <variant V = variant::lagrange, root_form F = root_form::stable, number T, int N>
requires field_number<T> && has_variant<V, T>
[[nodiscard]] constexpr ball_solution<N, T> solve_with_inverse_masses(const ball<N, T>& a, const ball<N, T>& b,
                                                                      const T& inverse_a, const T& inverse_b) {
    return detail::solve_balls<F>(a, b, inverse_a, inverse_b, [](const auto& m, const quadratic<T, T, T>& q) {
        return detail::discriminant_by<V, T>(q, [&] { return T(discriminant_lagrange{}(m)); });
    });
}

// The whole solution of two balls. In an inexact T it promises no more than the formulas: for exact decisions and
// rounded results use classify, time_of_impact and collide. Does not check its input.
template <variant V = variant::lagrange, root_form F = root_form::stable, number T, int N>
requires field_number<T> && has_variant<V, T>
[[nodiscard]] constexpr ball_solution<N, T> solve(const ball<N, T>& a, const ball<N, T>& b) {
    const T one(1);
    return solve_with_inverse_masses<V, F, T, N>(a, b, one / a.mass, one / b.mass);
}

} // namespace graze::inline v0_1
