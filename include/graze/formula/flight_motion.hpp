// Two flights seen from the second at the later epoch, and quadratics whose times count from another instant.
#pragma once

#include <graze/formula/quadratic.hpp>
#include <graze/shape/flight.hpp>

#include <utility>

namespace graze::inline v0_1 {

// The relative motion at the later of two epochs, from the motion m of the balls as each is at its own epoch. u is the
// velocity of the ball with the earlier epoch. lead is the epoch of b less that of a. dx is then m.dx + u lead.
template <int N, class X, class V, class S, class U, class E>
[[nodiscard]] constexpr auto with_lead(const relative_motion<N, X, V, S>& m, const vec<N, U>& u, const E& lead) {
    auto dx = m.dx + lead * u;
    return relative_motion{std::move(dx), m.du, m.R};
}

// At t0, the later epoch: dx = (x_a + u_a (t0 - since_a)) - (x_b + u_b (t0 - since_b)), where one of the two has not
// moved yet. F is any type with a state and a since, whose numbers may be of different types.
template <class F>
[[nodiscard]] constexpr auto relative_motion_of_flights(const F& a, const F& b) {
    const auto lead = b.since - a.since;
    return with_lead(relative_motion_between(a.state, b.state),
                     graze::sign(lead) > 0 ? a.state.velocity : b.state.velocity, lead);
}
template <int N, class T>
[[nodiscard]] constexpr auto relative_motion_of(const flight<N, T>& a, const flight<N, T>& b) {
    return relative_motion_of_flights(a, b);
}

// The same parabola, with times that count from an instant earlier by `start`: its roots are larger by `start`.
template <class A, class H, class C, class S>
[[nodiscard]] constexpr auto counted_from(const quadratic<A, H, C>& q, const S& start) {
    const auto shift = q.a * start;
    return quadratic{q.a, q.h - shift, q.c + (shift - graze::twice(q.h)) * start};
}

} // namespace graze::inline v0_1
