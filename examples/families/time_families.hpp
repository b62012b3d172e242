// Balls that certainly, or almost certainly, collide. What is hard is the time.
#pragma once

#include "passage.hpp"
#include "range_families.hpp"

namespace families {

// The velocities agree in their first k bits, k from 20 to 51. So their difference has few bits left, and the collision
// is far off.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> almost_equal_velocities(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int k = 20 + static_cast<int>(index % 32);
    const int bits = 51 - k;
    integers<N> du = random_vector<N>(r, bits);
    const std::size_t fastest = r.below(N);
    du[fastest] = r.either_sign(std::int64_t{1} << bits);
    integers<N> dx = times<N>(-r.in(std::int64_t{1} << (k - 2), std::int64_t{1} << (k - 1)), du);
    for (std::int64_t& x : dx) {
        x += r.signed_bits(48);
    }
    relative<N> m{dx, du, r.in(std::int64_t{1} << 46, std::int64_t{1} << 48)};
    pair_of_doubles<N> pair = balls<N>(r, m);
    pair.hardness = k;
    return pair;
}

// Pairs 2i and 2i + 1 collide at exactly equal times: one is the other with its axes permuted and reflected, or with
// its balls exchanged. For every fourth i a radius of the second is off by one unit in the last place.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> equal_times(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index / 2);
    pair_of_doubles<N> pair = head_on<N>(r);
    if (index % 2 == 0) {
        return pair;
    }
    const int shift = static_cast<int>(r.below(N));
    const auto reflected = r.next();
    const pair_of_doubles<N> original = pair;
    for (int i = 0; i < N; ++i) {
        const int from = (i + shift) % N;
        const bool flip = (reflected >> i & 1U) != 0;
        const auto image = [&](double x) { return flip ? negated(x) : x; };
        pair.a.position[i] = image(original.a.position[from]);
        pair.a.velocity[i] = image(original.a.velocity[from]);
        pair.b.position[i] = image(original.b.position[from]);
        pair.b.velocity[i] = image(original.b.velocity[from]);
    }
    if (r.one_in(2)) {
        std::swap(pair.a, pair.b);
    }
    if (index / 2 % 4 == 3) {
        nudge(r, pair.a.radius);
    }
    return pair;
}

// τ is rational. By index modulo 3: it is exactly between two doubles; it is a double; or it would be exactly between
// two doubles, but a radius is off by one unit in the last place. Only exact arithmetic tells the first from the last.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> ties(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const passage<N> p = random_passage<N>(r, 58);
    integers<N> du{};
    while (dot<N>(du, p.axes.axis[0]) == 0) {
        du = random_vector<N>(r, 6);
    }
    if (dot<N>(du, p.axes.axis[0]) > 0) {
        du = times<N>(-1, du);
    }
    std::int64_t time = r.in(std::int64_t{1} << 52, (std::int64_t{1} << 53) - 1); // 53 bits
    time = index % 3 == 1 ? time : 2 * time + 1;
    relative<N> m{sum<N>(p.foot, times<N>(-time, du)), du, p.distance, 0, -58, -5}; // contact at p.foot
    m.velocity_bits = 8;
    pair_of_doubles<N> pair = balls<N>(r, m);
    if (index % 3 == 2) {
        nudge(r, pair.a.radius);
    }
    return pair;
}

} // namespace families
