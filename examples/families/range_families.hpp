// Ordinary balls, and balls over the whole range of a double.
#pragma once

#include "pair.hpp"

namespace families {

// A random number of magnitude below 1 with 53 random bits: as a double, and in units of 2^-50, rounded down.
struct coordinate {
    double value;
    std::int64_t units;
};

[[nodiscard]] constexpr coordinate random_coordinate(random& r) {
    const std::int64_t significand = (std::int64_t{1} << 52) + static_cast<std::int64_t>(r.next() >> 12U);
    const int smaller = std::countr_zero(r.next() | std::uint64_t{1} << 30U);
    const std::int64_t signed_one = r.either_sign(significand);
    return {make_double(signed_one, -53 - smaller), signed_one >> (3 + smaller)};
}

// Random positions and velocities in [-1, 1] and radii in [0, 1/2]: the only difficulty is the rounding. At odd indices
// a's velocity is aimed roughly at b.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> generic(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    pair_of_doubles<N> pair;
    for (int i = 0; i < N; ++i) {
        const coordinate xa = random_coordinate(r), xb = random_coordinate(r);
        const coordinate ua = random_coordinate(r), ub = random_coordinate(r);
        pair.a.position[i] = xa.value;
        pair.b.position[i] = xb.value;
        pair.b.velocity[i] = ub.value;
        pair.a.velocity[i] =
            index % 2 == 0 ? ua.value : make_double((xb.units - xa.units) / 2 + ub.units + ua.units / 8, -50);
    }
    pair.a.radius = make_double(r.in(0, std::int64_t{1} << 53), -54);
    pair.b.radius = make_double(r.in(0, std::int64_t{1} << 53), -54);
    pair.a.mass = random_mass(r);
    pair.b.mass = random_mass(r);
    return pair;
}

// Certainly a hit: the velocity points at the other ball, with an error smaller than the radii.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> head_on(random& r) {
    integers<N> dx = random_vector<N>(r, 50);
    const std::size_t longest = r.below(N);
    dx[longest] = r.either_sign(r.in(std::int64_t{1} << 50, std::int64_t{1} << 51));
    integers<N> du = random_vector<N>(r, 45);
    for (std::size_t i = 0; i < N; ++i) {
        du[i] -= dx[i] / 4;
    }
    const std::int64_t size = dx[longest] < 0 ? -dx[longest] : dx[longest];
    return balls<N>(r, {dx, du, r.in(size / 4, size / 2)});
}

// Masses from 2^-50 to 2^50, and at every fourth index an infinite one. The velocities after the collision lose the
// small change of the heavy ball. A type without an infinity must take the inverses of masses.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> masses(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    pair_of_doubles<N> pair = head_on<N>(r);
    pair.hardness = static_cast<int>(index % 51);
    pair.a.mass = times_power_of_two(pair.a.mass, pair.hardness);
    if (index % 4 == 3) {
        pair.a.mass = std::bit_cast<double>(std::uint64_t{0x7ff} << 52U);
        pair.hardness = -1;
    }
    if (r.one_in(2)) {
        std::swap(pair.a, pair.b);
    }
    return pair;
}

// Every length of a generic pair times 2^±500, and every velocity times 2^±500 or 1: squares overflow or vanish.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> scaled(std::uint64_t seed, std::uint64_t index) {
    pair_of_doubles<N> pair = generic<N>(seed, index);
    const int length = index / 2 % 2 == 0 ? 500 : -500;
    const int velocity = static_cast<int>(index / 4 % 3) * 500 - 500;
    for (graze::ball<N, double>* b : {&pair.a, &pair.b}) {
        for (int i = 0; i < N; ++i) {
            b->position[i] = times_power_of_two(b->position[i], length);
            b->velocity[i] = times_power_of_two(b->velocity[i], velocity);
        }
        b->radius = times_power_of_two(b->radius, length);
    }
    return pair;
}

// Subnormal lengths, and at odd indices subnormal velocities too: at most 2^51 units of the smallest double, so that
// every product vanishes. Flushing subnormals to zero removes the balls.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> subnormal(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int bits = static_cast<int>(r.in(4, 49));
    const integers<N> dx = random_vector<N>(r, bits);
    integers<N> du = random_vector<N>(r, bits);
    for (std::size_t i = 0; i < N && index / 2 % 2 == 0; ++i) {
        du[i] = du[i] / 4 - dx[i];
    }
    relative<N> m{dx, du, r.in(1, std::int64_t{1} << (bits - 1)), 0, -1074, index % 2 == 0 ? -bits : -1074};
    m.position_bits = m.velocity_bits = bits;
    return balls<N>(r, m);
}

// Each coordinate, velocity component and radius has its own exponent, within 2^±200 or, at every fourth index, within
// 2^±1000 (where products overflow). The exact answer needs thousands of bits.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> own_exponents(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int spread = index % 4 == 3 ? 1000 : 200;
    const auto any = [&] {
        const double x = random_coordinate(r).value;
        return times_power_of_two(x, static_cast<int>(r.in(-spread, spread)));
    };
    pair_of_doubles<N> pair;
    for (graze::ball<N, double>* b : {&pair.a, &pair.b}) {
        for (int i = 0; i < N; ++i) {
            b->position[i] = any();
            b->velocity[i] = any();
        }
        b->radius = any();
        b->radius = b->radius < 0 ? negated(b->radius) : b->radius;
        b->mass = random_mass(r);
    }
    return pair;
}

} // namespace families
