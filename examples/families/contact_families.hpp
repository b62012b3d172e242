// Balls that touch, or almost touch. What is hard is the sign and the size of c = |Δx|² - R².
#pragma once

#include "passage.hpp"

namespace families {

// A random direction towards (sign = -1) or away from (+1) axis[0] of the frame.
template <int N>
[[nodiscard]] constexpr integers<N> random_velocity_towards(random& r, const frame<N>& axes, int sign, int bits) {
    integers<N> u = random_vector<N>(r, bits);
    const std::int64_t along = dot<N>(u, axes.axis[0]);
    return (along < 0) == (sign < 0) ? u : times<N>(-1, u);
}

// The gap between the balls is 2^-k R to within a factor of 2, k from 4 to 56, so that rounding loses c. Half of the
// pairs close the gap straight; three in eight move so much sideways that they may miss; one in eight recedes.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> near_contact(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int k = 4 + static_cast<int>(index % 53);
    const passage<N> p = random_passage<N>(r, 48);
    const int finer = std::max(0, k - 44);
    const std::int64_t distance = p.distance << finer;
    const std::int64_t R = distance - random_fraction(r, distance, k);
    relative<N> m{p.foot, {}, R, finer};
    const auto how = r.below(8);
    if (how < 5) {
        m.du = random_velocity_towards(r, p.axes, how == 0 ? 1 : -1, 48);
    } else { // a hit if the inward part of the velocity is more than about √(2·2^-k) of it
        const std::int64_t sideways = r.in(std::int64_t{1} << 30, std::int64_t{1} << 31);
        const std::int64_t border = sideways * p.along.weight >> ((k - 1) / 2);
        const std::int64_t inward = r.in(border / 8, border + 1);
        m.du = sum<N>(times<N>(-inward, p.axes.axis[0]), times<N>(sideways, p.along.vector));
    }
    pair_of_doubles<N> pair = balls<N>(r, m);
    pair.hardness = k;
    return pair;
}

// |Δx| = R exactly; at every fourth index one number of a ball is off by one unit in the last place. The balls approach
// (a hit at τ = 0), part, or slide along each other (h = 0).
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> touching(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const passage<N> p = random_passage<N>(r, 50);
    const auto how = r.below(8);
    const integers<N> du = how < 2 ? random_speed(r, p, 51) : random_velocity_towards(r, p.axes, how < 4 ? 1 : -1, 48);
    pair_of_doubles<N> pair = balls<N>(r, {p.foot, du, p.distance});
    if (index % 4 == 3) {
        nudge_one(r, pair.a);
    }
    return pair;
}

// Pairs as rounding leaves them after a bounce: each component of Δx is up to one unit in the last place away from a
// contact, and the balls part. About half of the pairs overlap, which is no collision. One pair in four parts so
// slowly, almost like a graze, that rounding may reverse its velocity.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> after_bounce(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const passage<N> p = random_passage<N>(r, 51);
    relative<N> m{sum<N>(p.foot, random_vector<N>(r, 1)), {}, p.distance};
    if (r.one_in(4)) {
        m.du = random_speed(r, p, 50);
        m.du = sum<N>(m.du, random_vector<N>(r, 2));
    } else {
        m.du = random_velocity_towards(r, p.axes, 1, 48);
    }
    return balls<N>(r, m);
}

} // namespace families
