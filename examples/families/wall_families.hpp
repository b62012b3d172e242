// Balls against planes and walls.
#pragma once

#include "beside_wall.hpp"
#include "passage.hpp"
#include "range_families.hpp"

namespace families {

// A random wall or, at every fourth index, a random plane, and a ball. At every other index the ball's velocity is
// aimed at a point of it. Only the rounding is hard.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> generic_wall(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    pair_of_doubles<N> pair;
    pair.kind = index % 4 == 0 ? pair_kind::ball_plane : pair_kind::ball_wall;
    std::array<std::int64_t, N - 1> where{}; // eighths of the edges
    for (std::int64_t& eighths : where) {
        eighths = r.in(0, 8);
    }
    for (int i = 0; i < N; ++i) {
        const coordinate x = random_coordinate(r), u = random_coordinate(r), corner = random_coordinate(r);
        std::int64_t target = corner.units;
        for (std::size_t e = 0; e < where.size(); ++e) {
            const coordinate edge = random_coordinate(r);
            pair.wall.edge[e][i] = edge.value;
            target += edge.units / 8 * where[e];
        }
        pair.a.position[i] = x.value;
        pair.a.velocity[i] = r.one_in(2) ? u.value : make_double((target - x.units) / 2 + u.units / 8, -50);
        pair.wall.corner[i] = corner.value;
        pair.plane.point[i] = corner.value;
        pair.plane.normal[i] = pair.wall.edge[0][i];
    }
    pair.a.radius = make_double(r.in(0, std::int64_t{1} << 52), -54);
    pair.a.mass = random_mass(r);
    return pair;
}

// The least distance from the wall is r(1 ± 2^-k) to within a factor of 2 of 2^-k, k from 1 to 52, and it is the
// distance from a corner or, in space at odd indices, from a point within an edge. The wall stays on the other side of
// the path's tangent plane there.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> edges_and_corners(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int k = 1 + static_cast<int>(index / 2 % 52);
    const passage<N> p = random_passage<N>(r, 48);
    constexpr std::int64_t size = std::int64_t{1} << 30;
    ball_and_wall<N> m{p.start, random_speed(r, p, 51), {}, 0, 5};
    const std::int64_t distance = p.distance << m.finer;
    m.radius = distance + r.either_sign(random_fraction(r, distance, k));
    m.radius -= m.radius >> 53 != 0 ? m.radius % 2 : 0;
    const auto away = [&] { // a direction that leads away from the path more than sideways
        integers<N> factors{-r.in(32, 63)};
        for (std::size_t i = 1; i < N; ++i) {
            factors[i] = r.in(-31, 31);
        }
        return combination<N>(p.axes, factors);
    };
    const integers<N> first = away();
    m.edge[0] = times<N>(size, first);
    if constexpr (N == 3) {
        integers<3> second{};
        if (index % 2 == 0) {
            do {
                second = away();
            } while (parallel(first, second));
            m.edge[1] = times<3>(size, second);
        } else {
            do {
                second = random_cross_direction<3>(r, p.axes).vector;
            } while (parallel(second, p.along.vector));
            m.edge[1] = times<3>(size / 2, second);
            m.w = sum<3>(m.w, times<3>(r.in(size / 8, size / 8 * 3), second)); // the edge is under the foot
        }
    }
    turn_about(r, m);
    pair_of_doubles<N> pair = ball_beside_wall(r, m);
    pair.hardness = k;
    return pair;
}

// The ball first touches the wall on the border between its face and an edge (in the plane, between the segment and an
// end) or, in space at every other pair of indices, between an edge and a corner. At odd indices one number of the ball
// is off by one unit in the last place.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> borders(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const passage<N> p = random_passage<N>(r, 47);
    constexpr std::int64_t size = std::int64_t{1} << 30;
    ball_and_wall<N> m{};
    m.radius = p.distance;
    m.u = random_vector<N>(r, 44);
    while (dot<N>(m.u, p.axes.axis[0]) >= 0) {
        m.u = random_vector<N>(r, 44);
    }
    m.w = sum<N>(p.foot, times<N>(-r.in(4, 31), m.u)); // the touching point is the corner
    if constexpr (N == 2) {
        m.edge[0] = times<2>(size, p.along.vector);
    } else {
        const bool corner = index / 2 % 2 == 0;
        m.edge[0] = times<3>(size, combination<N>(p.axes, {corner ? -r.in(1, 31) : 0, r.signed_bits(5), r.in(1, 31)}));
        m.edge[1] = times<3>(4 * size * r.in(1, 8), p.axes.axis[1]);
        if (!corner) {
            m.w = sum<3>(m.w, times<3>(size * r.in(0, 4), p.axes.axis[1])); // the touching point is on edge[1]
        }
    }
    turn_about(r, m);
    pair_of_doubles<N> pair = ball_beside_wall(r, m);
    if (index % 2 == 1) {
        nudge_one(r, pair.a);
    }
    return pair;
}

// Pairs 2i and 2i + 1 are the same ball and the two sides of a wedge into which it flies along the middle: it meets
// both at once, at a time that is not rational where the sides stand at 45 degrees to its path (every other i). For
// every fourth i the ball is one unit in the last place off the middle.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> two_walls(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index / 2);
    const frame<N> f = random_frame<N>(r);
    const std::int64_t along = r.in(1, 8), across = index / 2 % 2 == 0 ? along : r.in(1, 8);
    const std::int64_t length = (std::int64_t{1} << 46) / f.length;
    ball_and_wall<N> m{};
    m.radius = r.in(std::int64_t{1} << 44, std::int64_t{1} << 45);
    integers<N> from{-r.in(length * 8, length * 16)}, speed{r.in(length / 2, length)}, side{-along * length};
    side[1] = across * length;
    if constexpr (N == 3) {
        speed[2] = r.in(-length / 16, length / 16);
        from[2] = r.in(length * 6, length * 10); // measured from the wedge's lower end
        m.edge[1] = times<3>(16 * length, f.axis[2]);
    }
    m.w = combination<N>(f, from);
    m.u = combination<N>(f, speed);
    std::array<integers<N>, 2> sides{};
    sides[0] = times<N>(4, combination<N>(f, side));
    side[1] = -side[1];
    sides[1] = times<N>(4, combination<N>(f, side));
    m.edge[0] = sides[index % 2];
    pair_of_doubles<N> pair = ball_beside_wall(r, m); // the same numbers for both sides
    if (index / 2 % 4 == 3) {
        nudge(r, pair.a.position[static_cast<int>(r.below(N))]);
    }
    return pair;
}

} // namespace families
