// Two balls seen from the second: Eqs. (1), (2) and (27).
#pragma once

#include <graze/shape/ball.hpp>

#include <utility>

namespace graze::inline v0_1 {

// dx = Δx points from b to a (errata: not from a to b), du = Δu, R is the sum of the radii.
template <int N, class X, class U, class S>
struct relative_motion {
    vec<N, X> dx;
    vec<N, U> du;
    S R;
};
template <int N, class X, class U, class S>
relative_motion(vec<N, X>, vec<N, U>, S) -> relative_motion<N, X, U, S>;

// B is any type with a position, a velocity and a radius, whose numbers may be of different types. Always inlined: in a
// long file a compiler might otherwise write two balls to memory and call it.
template <class B>
[[nodiscard, gnu::always_inline]] constexpr inline auto relative_motion_between(const B& a, const B& b) {
    auto dx = a.position - b.position; // (2)
    auto du = a.velocity - b.velocity; // (27)
    auto R = a.radius + b.radius;      // (1)
    return relative_motion{std::move(dx), std::move(du), std::move(R)};
}
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline auto relative_motion_of(const ball<N, T>& a, const ball<N, T>& b) {
    return relative_motion_between(a, b);
}

} // namespace graze::inline v0_1
