// Balls that fly at a box whose sides are parallel to the axes or, in the plane, at a segment, in doubles made from
// integers: the same on every machine.
#pragma once

#include <families/passage.hpp>

namespace peers {

enum class approach { generic, grazing, far, near_contact, parting };

// All in units of 2^-50. In the plane, a box with a half side of 0 is a segment.
template <int N>
struct ball_and_box {
    families::integers<N> middle{}, half{}, from{}, velocity{}; // from: relative to the middle
    std::int64_t radius = 0;
    int finer = 0; // the radius is in units of 2^-(50 + finer)
};

namespace detail {

using families::random;

constexpr std::int64_t unit = std::int64_t{1} << 46;

// A point above a side at `height`, within the extent of the other sides.
template <int N>
constexpr void above_a_side(random& r, ball_and_box<N>& m, std::size_t side, std::int64_t height) {
    for (std::size_t i = 0; i < N; ++i) {
        m.from[i] = i == side ? m.half[i] + height : r.in(-m.half[i], m.half[i]);
    }
}

template <int N>
constexpr void reflect(random& r, ball_and_box<N>& m) {
    for (std::size_t i = 0; i < N; ++i) {
        if (r.one_in(2)) {
            m.from[i] = -m.from[i];
            m.velocity[i] = -m.velocity[i];
        }
    }
}

// Past the edge between the sides i and j (in the plane: the corner) at the distance r(1 ± 2^-k).
template <int N>
constexpr void past_an_edge(random& r, ball_and_box<N>& m, int k) {
    auto p = families::random_passage<2>(r, 47);
    while (p.foot[0] == 0 || p.foot[1] == 0) {
        p = families::random_passage<2>(r, 47);
    }
    const auto speed = families::random_speed(r, p, 50);
    m.finer = std::max(0, k - 43);
    const std::size_t free = r.below(N);
    const std::size_t i = N == 2 ? 0 : (free + 1) % N, j = N == 2 ? 1 : (free + 2) % N;
    const std::size_t axis[2] = {i, j};
    for (std::size_t a = 0; a < 2; ++a) { // turns the foot into the edge's quadrant
        const std::int64_t sign = p.foot[a] < 0 ? -1 : 1;
        m.from[axis[a]] = m.half[axis[a]] + sign * p.start[a];
        m.velocity[axis[a]] = sign * speed[a];
    }
    if constexpr (N == 3) { // along the edge any motion will do that stays beside it
        m.from[free] = r.in(-m.half[free] / 4, m.half[free] / 4);
        m.velocity[free] = r.signed_bits(40);
    }
    const std::int64_t distance = p.distance << m.finer;
    m.radius = distance + r.either_sign(families::random_fraction(r, distance, k));
}

} // namespace detail

// k: for grazing, far and near_contact, as in the families of these names. flat: a segment.
template <int N>
[[nodiscard]] constexpr ball_and_box<N> draw_box(approach how, int k, bool flat, std::uint64_t seed,
                                                 std::uint64_t index) {
    families::random r(seed, index);
    ball_and_box<N> m;
    for (std::size_t i = 0; i < N; ++i) {
        m.middle[i] = r.signed_bits(50);
        m.half[i] = r.in(4 * detail::unit, 16 * detail::unit);
    }
    if (flat) {
        m.half[1] = 0;
    }
    m.radius = r.in(detail::unit, 8 * detail::unit);
    const std::size_t side = flat ? 1 : r.below(N);
    switch (how) {
    case approach::generic: // from 2 to 4 boxes away, towards a point in the box or near it
        for (std::size_t i = 0; i < N; ++i) {
            const std::int64_t target = r.in(-m.half[i] * 3 / 2 - m.radius, m.half[i] * 3 / 2 + m.radius);
            m.from[i] = i == side ? r.in(32 * detail::unit, 64 * detail::unit) : r.signed_bits(51);
            m.velocity[i] = (target - m.from[i]) / 2;
        }
        break;
    case approach::grazing:
        detail::past_an_edge(r, m, k);
        break;
    case approach::far: { // 32 velocities away; the box and the ball are about 2^-k of that distance
        for (std::size_t i = 0; i < N; ++i) {
            m.half[i] >>= k - 3;
            const std::int64_t target = r.in(-(m.half[i] * 3 / 2), m.half[i] * 3 / 2);
            const std::int64_t step = i == side ? r.in(detail::unit / 2, detail::unit) : r.signed_bits(45);
            m.velocity[i] = -step;
            m.from[i] = target + 32 * step;
        }
        m.radius >>= k - 3;
        break;
    }
    case approach::near_contact: { // 2^-k of the radius above a side
        detail::above_a_side(r, m, side, m.radius);
        for (std::size_t i = 0; i < N; ++i) {
            m.velocity[i] = i == side ? -r.in(detail::unit / 4, detail::unit) : r.signed_bits(45);
        }
        m.finer = std::max(0, k - 43);
        m.radius <<= m.finer;
        m.radius -= families::random_fraction(r, m.radius, k);
        break;
    }
    case approach::parting: // what rounding leaves of a contact with a side: a unit in the last place more or less
        detail::above_a_side(r, m, side, m.radius + r.in(-1, 1));
        for (std::size_t i = 0; i < N; ++i) {
            m.velocity[i] = i == side ? r.in(detail::unit / 4, detail::unit) : r.signed_bits(45);
        }
        break;
    }
    detail::reflect(r, m);
    return m;
}

} // namespace peers
