// More families than those of the examples: planes, walls over the whole range, and everything on small grids.
#pragma once

#include "integer_pair.hpp"

namespace families {

// Small whole numbers, with all ties and degenerate cases, including points and sliding. At every fourth index one
// number of the ball is off by a unit in the last place. The units are random powers of two.
template <int N, pair_kind Kind>
[[nodiscard]] constexpr pair_of_doubles<N> small_grid(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    integer_pair<N> m;
    m.w = random_vector<N>(r, static_cast<int>(r.in(2, 4)));
    m.u = random_vector<N>(r, static_cast<int>(r.in(1, 2)));
    m.x = random_vector<N>(r, 3);
    m.edge = random_edges<N>(r, 2);
    m.radius = r.in(0, 5);
    if (Kind == pair_kind::ball_ball) {
        m.v = random_vector<N>(r, 2);
        m.other_radius = r.in(0, 3);
    }
    if constexpr (N == 3 && Kind == pair_kind::ball_wall) {
        if (r.one_in(2)) { // a wall across the third axis, along which the ball might not move
            m.edge = {{{r.in(1, 3), r.in(-1, 1), 0}, {r.in(-1, 1), r.in(2, 4), 0}}};
            m.u[2] *= r.in(0, 1);
        }
    }
    const int spread = r.one_in(2) ? 10 : 200;
    const auto unit = [&] { return static_cast<int>(r.in(-spread, spread)); };
    const int length = unit(), velocity = unit(), normal = unit();
    pair_of_doubles<N> pair = make_pair(Kind, m, length, velocity, normal);
    if (index % 4 == 3) {
        nudge_one(r, pair.a);
    }
    return pair;
}

// A ball and a plane, or a wall that is large compared with the ball. The ball is at exactly its radius from it, or
// 2^-k of that nearer or farther, and moves towards it, away or along it. At every fourth index one number of the ball
// is off by a unit in the last place.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> face_contact(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const frame<N> f = random_frame<N>(r);
    const std::int64_t factor = r.in(std::int64_t{1} << 34, std::int64_t{1} << 35);
    integers<N> height{r.either_sign(factor)}, along{r.in(-2, 1) * height[0] / 1024};
    for (std::size_t i = 1; i < N; ++i) {
        height[i] = r.signed_bits(34);
        along[i] = r.signed_bits(24);
    }
    integer_pair<N> m;
    m.x = random_vector<N>(r, 50);
    m.w = combination<N>(f, height);
    m.u = combination<N>(f, along);
    m.radius = factor * f.length;
    if (r.one_in(2)) {
        m.radius += r.either_sign(m.radius >> r.in(1, 46));
    }
    const bool wall = index / 4 % 2 == 0;
    m.edge[0] = times<N>(r.in(1, 7), f.axis[0]);
    if (wall) {
        constexpr std::int64_t size = std::int64_t{1} << 38;
        integers<N> corner{};
        for (std::size_t i = 1; i < N; ++i) {
            integers<N> side{};
            side[i] = 2 * size;
            corner[i] = size;
            m.edge[i - 1] = combination<N>(f, side);
        }
        m.w = sum<N>(m.w, combination<N>(f, corner));
    }
    pair_of_doubles<N> pair = make_pair(wall ? pair_kind::ball_wall : pair_kind::ball_plane, m, -50, -50, 0);
    if (index % 4 == 3) {
        nudge_one(r, pair.a);
    }
    return pair;
}

// A point that flies at the border of a wall, or along the wall itself.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> points_and_walls(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    integer_pair<N> m;
    m.x = random_vector<N>(r, 48);
    m.edge = random_edges<N>(r, 20);
    m.u = random_vector<N>(r, 20);
    if (r.one_in(2)) { // in the wall's own plane
        m.u = {};
        for (const integers<N>& e : m.edge) {
            m.u = sum<N>(m.u, times<N>(r.in(-4, 4), e));
        }
    }
    m.w = times<N>(-r.in(1, 1 << 20), m.u);
    for (integers<N>& e : m.edge) { // the target: in eighths of the edges, every other time at an end
        m.w = sum<N>(m.w, times<N>(r.one_in(2) ? 8 * r.in(0, 1) : r.in(-1, 9), e));
        e = times<N>(8, e);
    }
    pair_of_doubles<N> pair = make_pair(pair_kind::ball_wall, m, -50, -50, 0);
    if (index % 4 == 3) {
        nudge_one(r, pair.a);
    }
    return pair;
}

// Walls with nearly parallel edges (in the plane: a generic wall), so that their products cancel.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> thin_walls(std::uint64_t seed, std::uint64_t index) {
    pair_of_doubles<N> pair = generic_wall<N>(seed, 4 * index + 1 + index % 3);
    random r(seed, index);
    if constexpr (N == 3) {
        graze::vec<3, double>& x = pair.wall.edge[0];
        graze::vec<3, double>& y = pair.wall.edge[1];
        const int power = static_cast<int>(r.in(-2, 2));
        for (int i = 0; i < 3; ++i) {
            y[i] = times_power_of_two(x[i], power);
        }
        const int which = static_cast<int>(r.below(3));
        y[which] = beside(y[which], r.one_in(2) ? 1 : -1);
    }
    return pair;
}

// Planes and walls, everything times 2^±500: squares overflow or vanish.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> scaled_walls(std::uint64_t seed, std::uint64_t index) {
    pair_of_doubles<N> pair = generic_wall<N>(seed, index);
    const auto power = [](std::uint64_t digit) { return static_cast<int>(digit % 3) * 500 - 500; };
    scale(pair, power(index / 4), power(index / 12), power(index / 36));
    return pair;
}

// Planes and walls in multiples of the smallest double: every product vanishes.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> subnormal_walls(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int bits = static_cast<int>(r.in(4, 30));
    integer_pair<N> m;
    m.x = random_vector<N>(r, bits);
    m.w = random_vector<N>(r, bits);
    m.u = random_vector<N>(r, bits);
    m.edge = random_edges<N>(r, bits);
    for (std::size_t i = 0; i < N && r.below(4) != 0; ++i) { // roughly at the middle of the wall
        m.u[i] = m.u[i] / 4 - m.w[i] + (m.edge.front()[i] + m.edge.back()[i]) / 2;
    }
    m.radius = r.in(0, std::int64_t{1} << (bits - 2));
    const auto kind = index % 4 == 0 ? pair_kind::ball_plane : pair_kind::ball_wall;
    return make_pair(kind, m, -1074, index / 4 % 2 == 0 ? -1074 : -bits, index / 8 % 2 == 0 ? -1074 : 0);
}

// Planes and walls in which every number has its own exponent, within 2^±200 or, at every fourth index, within 2^±1000.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> own_exponents_walls(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    const int spread = index % 4 == 3 ? 1000 : 200;
    const auto any = [&] {
        return times_power_of_two(random_coordinate(r).value, static_cast<int>(r.in(-spread, spread)));
    };
    pair_of_doubles<N> pair;
    pair.kind = index / 4 % 3 == 0 ? pair_kind::ball_plane : pair_kind::ball_wall;
    for (int i = 0; i < N; ++i) {
        pair.a.position[i] = any();
        pair.a.velocity[i] = any();
        pair.plane.point[i] = pair.wall.corner[i] = any();
        pair.plane.normal[i] = any();
        for (auto& e : pair.wall.edge) {
            e[i] = any();
        }
    }
    pair.a.radius = any();
    pair.a.radius = pair.a.radius < 0 ? negated(pair.a.radius) : pair.a.radius;
    return pair;
}

// An edge of 2^16 to 2^22 radii, all but along an axis, that is met far from its ends: what is left of the way from its
// corner to the ball is far smaller than that way. In the plane it is the wall's face.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> long_edges(std::uint64_t seed, std::uint64_t index) {
    random r(seed, index);
    constexpr std::int64_t one = std::int64_t{1} << 50;
    pair_of_doubles<N> pair;
    pair.kind = pair_kind::ball_wall;
    const auto axis = static_cast<int>(r.below(N));
    const int power = static_cast<int>(r.in(16, 20));
    const std::int64_t length = r.in(one, 2 * one - 1), eighths = r.in(1, 7), way = r.either_sign(1);
    pair.a.position[axis] = make_double(way * (length / 8 * eighths) + r.signed_bits(46), power - 50);
    pair.a.velocity[axis] = make_double(r.signed_bits(50), -50);
    pair.a.radius = make_double(r.in(one / 2, one), -50);
    pair.a.mass = random_mass(r);
    pair.wall.corner[axis] = make_double(r.signed_bits(50), -50);
    pair.wall.edge[0][axis] = make_double(way * length, power - 50);
    for (int k = 1; k < N; ++k) { // along the first of the other axes it comes from 3 away, along the second from 2
        const int i = (axis + k) % N;
        const std::int64_t side = r.either_sign(1), corner = r.signed_bits(50), slope = r.signed_bits(50);
        const std::int64_t speed = k == 1 ? r.in(one / 2, one) : r.in(one / 10 * 3, one / 10 * 6);
        pair.wall.corner[i] = make_double(corner, -50);
        pair.wall.edge[0][i] = make_double(slope, -50);
        pair.wall.edge[N - 2][i] = k == 2 ? make_double(side * one, -50) : pair.wall.edge[N - 2][i];
        pair.a.position[i] = make_double(corner + slope / 8 * eighths - (4 - k) * side * one, -50);
        pair.a.velocity[i] = make_double(side * speed, -50);
    }
    if (r.one_in(2)) {
        std::swap(pair.wall.edge.front(), pair.wall.edge.back());
    }
    return pair;
}

inline constexpr std::array more_families{
    family{"small_grid_balls", "", "", small_grid<2, pair_kind::ball_ball>, small_grid<3, pair_kind::ball_ball>},
    family{"small_grid_planes", "", "", small_grid<2, pair_kind::ball_plane>, small_grid<3, pair_kind::ball_plane>},
    family{"small_grid_walls", "", "", small_grid<2, pair_kind::ball_wall>, small_grid<3, pair_kind::ball_wall>},
    family{"face_contact", "", "", face_contact<2>, face_contact<3>},
    family{"points_and_walls", "", "", points_and_walls<2>, points_and_walls<3>},
    family{"thin_walls", "", "", thin_walls<2>, thin_walls<3>},
    family{"scaled_walls", "", "", scaled_walls<2>, scaled_walls<3>},
    family{"subnormal_walls", "", "", subnormal_walls<2>, subnormal_walls<3>},
    family{"own_exponents_walls", "", "", own_exponents_walls<2>, own_exponents_walls<3>},
    family{"long_edges", "", "", long_edges<2>, long_edges<3>},
};

} // namespace families
