// Balls that pass each other at an exactly known distance.
#pragma once

#include "pair.hpp"

namespace families {

// A straight path whose least distance from the origin is `distance`, an integer. It goes from start through foot, the
// point at that distance.
template <int N>
struct passage {
    frame<N> axes;
    integers<N> foot; // along axes.axis[0]
    std::int64_t distance;
    cross_direction<N> along;
    integers<N>
        start; // foot - along · a positive factor, 1 to 12 times as far from the foot as the foot from the origin
};

// A passage with a distance of 2^(bits - 1) to 2^bits, bits >= 16. start's components are below 2^(bits + 4).
template <int N>
[[nodiscard]] constexpr passage<N> random_passage(random& r, int bits) {
    passage<N> p{};
    p.axes = random_frame<N>(r);
    const std::int64_t largest = (std::int64_t{1} << bits) / p.axes.length;
    const std::int64_t factor = r.in(largest / 2 + 1, largest);
    p.foot = times<N>(factor, p.axes.axis[0]);
    p.distance = factor * p.axes.length;
    p.along = random_cross_direction<N>(r, p.axes);
    p.start = sum<N>(p.foot, times<N>(-(r.in(factor, 8 * factor) / p.along.weight + 1), p.along.vector));
    return p;
}

// A velocity along the passage with components below 2^bits.
template <int N>
[[nodiscard]] constexpr integers<N> random_speed(random& r, const passage<N>& p, int bits) {
    const std::int64_t largest = (std::int64_t{1} << bits) / (p.along.weight * p.axes.length);
    return times<N>(r.in(largest / 2 + 1, largest), p.along.vector);
}

// whole · 2^-k by less than a factor of 2: at least 1, more than whole · 2^-(k+1).
[[nodiscard]] constexpr std::int64_t random_fraction(random& r, std::int64_t whole, int k) {
    return r.in((whole >> (k + 1)) + 1, std::max<std::int64_t>(whole >> k, (whole >> (k + 1)) + 1));
}

} // namespace families
