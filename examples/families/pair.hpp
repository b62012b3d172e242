// A pair as doubles, and its assembly from integers.
#pragma once

#include "doubles.hpp"
#include "frame.hpp"

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace families {

enum class pair_kind { ball_ball, ball_plane, ball_wall };

// a and, by kind, b, plane or wall. An infinite mass is an infinity. hardness: the family's k, or -1.
template <int N>
struct pair_of_doubles {
    pair_kind kind = pair_kind::ball_ball;
    graze::ball<N, double> a{}, b{};
    graze::plane<N, double> plane{};
    graze::wall<N, double> wall{};
    int hardness = -1;
};

template <int N>
[[nodiscard]] constexpr graze::vec<N, double> make_vector(const integers<N>& x, int exponent) {
    graze::vec<N, double> result{};
    for (int i = 0; i < N; ++i) {
        result[i] = make_double(x[static_cast<std::size_t>(i)], exponent);
    }
    return result;
}

// From 1/4 to 4, with 53 random bits.
[[nodiscard]] constexpr double random_mass(random& r) {
    const std::int64_t significand = (std::int64_t{1} << 52) + static_cast<std::int64_t>(r.next() >> 12U);
    return make_double(significand, static_cast<int>(r.in(-54, -51)));
}

// The difference of two balls' positions, that of their velocities, and the sum of their radii, in units of 2^length,
// 2^velocity and 2^(length - finer).
template <int N>
struct relative {
    integers<N> dx, du;
    std::int64_t sum_of_radii;
    int finer = 0;
    int length = -50;
    int velocity = -50;
    int position_bits = 51; // of b's random position
    int velocity_bits = 51; // of b's random velocity
};

// A random y such that y and x = y + difference are both doubles. If x would be too long, y takes the low bits of the
// difference.
[[nodiscard]] constexpr std::int64_t random_subtrahend(random& r, std::int64_t difference, int bits) {
    const std::int64_t magnitude = difference < 0 ? -difference : difference;
    const int width = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(magnitude)));
    const int excess = std::max(width, bits) + 1 - 53;
    std::int64_t y = r.signed_bits(bits);
    if (excess > 0) {
        const std::int64_t grid = std::int64_t{1} << excess;
        const std::int64_t low = ((y + difference) % grid + grid) % grid;
        y -= low;
    }
    return y;
}

// Balls with those differences exactly. Their masses are random.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> balls(random& r, const relative<N>& m) {
    pair_of_doubles<N> pair;
    for (int i = 0; i < N; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const std::int64_t x = random_subtrahend(r, m.dx[at], m.position_bits);
        const std::int64_t u = random_subtrahend(r, m.du[at], m.velocity_bits);
        pair.b.position[i] = make_double(x, m.length);
        pair.a.position[i] = make_double(x + m.dx[at], m.length);
        pair.b.velocity[i] = make_double(u, m.velocity);
        pair.a.velocity[i] = make_double(u + m.du[at], m.velocity);
    }
    const int width = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(m.sum_of_radii)));
    const std::int64_t grid = std::int64_t{1} << std::max(0, width - 53);
    const std::int64_t largest = std::min(m.sum_of_radii, (std::int64_t{1} << 53) - grid);
    std::int64_t smaller = r.in(0, largest);
    smaller -= (smaller - m.sum_of_radii % grid + grid) % grid; // makes the other radius a multiple of the grid
    smaller = smaller < 0 ? smaller + grid : smaller;
    pair.a.radius = make_double(m.sum_of_radii - smaller, m.length - m.finer);
    pair.b.radius = make_double(smaller, m.length - m.finer);
    if (r.one_in(2)) {
        std::swap(pair.a.radius, pair.b.radius);
    }
    pair.a.mass = random_mass(r);
    pair.b.mass = random_mass(r);
    return pair;
}

// Moves x by one unit in the last place, up or down in magnitude; a zero stays.
constexpr void nudge(random& r, double& x) {
    if (x != 0.0) {
        x = beside(x, r.one_in(2) ? 1 : -1);
    }
}

// Moves one number of ball a by one unit in the last place.
template <int N>
constexpr void nudge_one(random& r, graze::ball<N, double>& a) {
    const auto which = static_cast<int>(r.below(2 * N + 1));
    nudge(r, which < N ? a.position[which] : which < 2 * N ? a.velocity[which - N] : a.radius);
}

} // namespace families
