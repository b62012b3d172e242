// Whether a number type is exact for a scene on a grid, at compile time.
#pragma once

#include <graze/analysis/bit_width.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>

namespace graze::inline v0_1 {

// A scene on a grid: every coordinate and radius is a whole number of steps below 2^length, every component of a
// velocity a whole number of other steps below 2^velocity. Both steps may be any power of two: 1/64 mm is as good as 1.
struct grid {
    int length;
    int velocity;
};

namespace detail {

template <int N>
[[nodiscard]] consteval ball<N, bit_width> ball_on(grid g) {
    return {make_vec<N>([&](int) { return bit_width::of(g.length); }),
            make_vec<N>([&](int) { return bit_width::of(g.velocity); }), bit_width::of(g.length), bit_width(1)};
}

} // namespace detail

// The number of bits of the widest number in a decision about two balls on the grid: of h, c and D in variant V.
template <int N, variant V = variant::lagrange>
[[nodiscard]] consteval int bits_to_decide(grid g) {
    const auto m = relative_motion_of(detail::ball_on<N>(g), detail::ball_on<N>(g));
    const auto q = quadratic_of(m);
    const bit_width d = V == variant::lagrange   ? discriminant_lagrange{}(m)
                        : V == variant::textbook ? discriminant_textbook{}(q)
                                                 : discriminant_halved{}(q);
    const int coefficients = q.h.bits > q.c.bits ? q.h.bits : q.c.bits;
    return d.bits > coefficients ? d.bits : coefficients;
}

// Whether solve<V> in T makes every decision about two balls on the grid exactly, because no step of it rounds.
template <class T, int N, variant V = variant::lagrange>
[[nodiscard]] consteval bool exact_in(grid g) {
    return bits_to_decide<N, V>(g) <= exact_bits<T>();
}

} // namespace graze::inline v0_1
