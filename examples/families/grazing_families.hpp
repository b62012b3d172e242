// Balls that just touch or just do not. What is hard is the sign of the discriminant.
#pragma once

#include "passage.hpp"

namespace families {

// The least distance m of the centres differs from R so little that (R² - m²)/R² is ±2^-k to within a factor of 2, k
// from 1 to 53: the two terms of the discriminant agree in their first k bits.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> grazing(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int k = 1 + static_cast<int>(index % 53);
    const passage<N> p = random_passage<N>(r, 48);
    const int finer = std::max(0, k - 44); // R needs the bits of its difference from m
    const std::int64_t m = p.distance << finer;
    const std::int64_t R = m + r.either_sign(random_fraction(r, m, k + 1));
    pair_of_doubles<N> pair = balls<N>(r, {p.start, random_speed(r, p, 51), R, finer});
    pair.hardness = k;
    return pair;
}

// Even indices: m = R, so that D = 0 exactly. Odd indices: the same with one number of a ball off by one unit in the
// last place. Any error of D makes the decision wrong.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> tangent(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const passage<N> p = random_passage<N>(r, 48);
    pair_of_doubles<N> pair = balls<N>(r, {p.start, random_speed(r, p, 51), p.distance});
    if (index % 2 == 1) { // a component that is not perpendicular to the foot, or the radius
        auto i = r.below(N);
        while (p.foot[i] == 0) {
            i = (i + 1) % N;
        }
        const auto at = static_cast<int>(i);
        const auto which = r.below(3);
        nudge(r, which == 0 ? pair.a.position[at] : which == 1 ? pair.a.velocity[at] : pair.a.radius);
    }
    return pair;
}

// The balls are 2^k radii apart, k from 0 to 48, and fly at each other so that they hit or miss by some fraction of R:
// h² and ac, of the size distance²·speed², cancel down to R²·speed².
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> far(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int k = static_cast<int>(index % 49);
    integers<N> du = random_vector<N>(r, 45);
    du[r.below(N)] = r.either_sign(r.in(std::int64_t{1} << 45, std::int64_t{1} << 46));
    const std::int64_t radius_scale = std::int64_t{1} << (51 - k); // in the unit of dx
    integers<N> dx = times<N>(-r.in(32, 63), du);
    for (std::int64_t& x : dx) {
        x += r.in(-3 * radius_scale, 3 * radius_scale);
    }
    const std::int64_t R = r.in(std::int64_t{1} << 51, (std::int64_t{1} << 52) - 1);
    pair_of_doubles<N> pair = balls<N>(r, {dx, du, R, k});
    pair.hardness = k;
    return pair;
}

// The radii are 2^-k of the distance, k from 49 to 400, below the last bit of the positions along the path. In one pair
// of eight the balls are points. The path is parallel to a coordinate axis or plane, where the offset can be that
// small.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> tiny_radii(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int k = 49 + static_cast<int>(index % 352);
    const std::size_t across = r.below(N);
    integers<N> du = random_vector<N>(r, 45);
    du[(across + 1) % N] = r.either_sign(r.in(std::int64_t{1} << 45, std::int64_t{1} << 46));
    du[across] = 0;
    const integers<N> dx = times<N>(-r.in(32, 63), du);
    const bool points = r.one_in(8);
    const std::int64_t R = points ? 0 : r.in(std::int64_t{1} << 51, (std::int64_t{1} << 52) - 1);
    const std::int64_t offset = points && r.one_in(2) ? 0 : r.either_sign(r.in(R / 2, R / 2 * 3 + 1));
    pair_of_doubles<N> pair = balls<N>(r, {dx, du, R, k});
    pair.b.position[static_cast<int>(across)] = 0.0;
    pair.a.position[static_cast<int>(across)] = make_double(offset, -50 - k);
    pair.hardness = points ? -1 : k;
    return pair;
}

// r_a + r_b is not a double, and the double nearest to it is the distance with which R must be compared: the least
// distance of the path (even indices) or the distance at t = 0 (odd indices). Adding the radii first turns a hit or a
// miss into a graze, and an overlap or a gap into a touch.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> rounded_radius_sum(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const frame<N> axes = random_frame<N>(r);
    const std::int64_t least = (std::int64_t{1} << 51) / axes.length + 1; // the distance is in [2^51, 2^52)
    const std::int64_t factor = r.in(least, 2 * least - 3);
    const integers<N> foot = times<N>(factor, axes.axis[0]);
    const std::int64_t distance = factor * axes.length;
    constexpr int finer = 9; // doubles of this size are 2^8 of these units apart
    const std::int64_t R = (distance << finer) + r.either_sign(r.in(1, 127));
    const cross_direction<N> along = random_cross_direction<N>(r, axes);
    relative<N> m{foot, times<N>(r.in(1, std::int64_t{1} << 30), along.vector), R, finer};
    if (index % 2 == 0) {
        m.dx = sum<N>(foot, times<N>(-(r.in(factor / 4, factor / 2) / along.weight), along.vector));
    } else {
        m.du = sum<N>(m.du, times<N>(-r.in(1, std::int64_t{1} << 38), axes.axis[0]));
    }
    m.position_bits = 40;
    return balls<N>(r, m);
}

// Even indices: grazes to within 2^-k, k from 40 to 56, whose differences x_a - x_b and u_a - u_b mostly have more than
// 53 bits, so that rounding them moves the path. Odd indices: positions and velocities with a common part 2^k, k from 1
// to 45, times as large as their differences. A result computed from a position or a velocity itself loses k bits.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> common_part(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    if (index % 2 == 0) {
        const int k = 40 + static_cast<int>(index / 2 % 17);
        const passage<N> p = random_passage<N>(r, 55);
        const std::int64_t m = p.distance << 5;
        const std::int64_t R = m + r.either_sign(random_fraction(r, m, k + 1));
        pair_of_doubles<N> pair = balls<N>(r, {p.start, random_speed(r, p, 59), R, 5, -58, -58});
        pair.hardness = k;
        return pair;
    }
    const int k = 1 + static_cast<int>(index / 2 % 45);
    const int bits = 51 - k;
    integers<N> dx = random_vector<N>(r, bits - 1);
    dx[r.below(N)] = r.either_sign(r.in(std::int64_t{1} << (bits - 1), std::int64_t{1} << bits));
    integers<N> du = random_vector<N>(r, bits);
    for (std::size_t i = 0; i < N && r.below(4) != 0; ++i) {
        du[i] = -dx[i] + du[i] / 4;
    }
    const std::int64_t R = r.in(std::int64_t{1} << 49, std::int64_t{1} << 51);
    pair_of_doubles<N> pair = balls<N>(r, {dx, du, R, k + 1});
    pair.hardness = k;
    return pair;
}

} // namespace families
