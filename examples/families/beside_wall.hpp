// A ball and a wall, assembled from integers.
#pragma once

#include "pair.hpp"

namespace families {

// A wall, and a ball with its position relative to the wall's corner, in units of 2^length and 2^velocity; the radius
// in units of 2^(length - finer).
template <int N>
struct ball_and_wall {
    integers<N> w, u;
    std::array<integers<N>, N - 1> edge;
    std::int64_t radius;
    int finer = 0;
    int length = -50;
    int velocity = -50;
};

// As doubles. The ball's position is drawn at random, and the wall placed accordingly.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> ball_beside_wall(random& r, const ball_and_wall<N>& m) {
    pair_of_doubles<N> pair;
    pair.kind = pair_kind::ball_wall;
    for (int i = 0; i < N; ++i) {
        const std::int64_t x = r.signed_bits(50);
        pair.a.position[i] = make_double(x, m.length);
        pair.wall.corner[i] = make_double(x - m.w[static_cast<std::size_t>(i)], m.length);
    }
    pair.a.velocity = make_vector<N>(m.u, m.velocity);
    for (std::size_t e = 0; e < m.edge.size(); ++e) {
        pair.wall.edge[e] = make_vector<N>(m.edge[e], m.length);
    }
    pair.a.radius = make_double(m.radius, m.length - m.finer);
    pair.a.mass = random_mass(r);
    return pair;
}

// The same wall from any of its corners, its edges in any order.
template <int N>
constexpr void turn_about(random& r, ball_and_wall<N>& m) {
    for (integers<N>& e : m.edge) {
        if (r.one_in(2)) {
            m.w = sum<N>(m.w, times<N>(-1, e));
            e = times<N>(-1, e);
        }
    }
    if (r.one_in(2)) {
        std::swap(m.edge.front(), m.edge.back());
    }
}

[[nodiscard]] constexpr bool parallel(const integers<3>& x, const integers<3>& y) { // components below 2^31
    return x[1] * y[2] == x[2] * y[1] && x[2] * y[0] == x[0] * y[2] && x[0] * y[1] == x[1] * y[0];
}

// An integer combination of the frame's axes.
template <int N>
[[nodiscard]] constexpr integers<N> combination(const frame<N>& f, const integers<N>& factors) {
    integers<N> result{};
    for (std::size_t i = 0; i < N; ++i) {
        result = sum<N>(result, times<N>(factors[i], f.axis[i]));
    }
    return result;
}

} // namespace families
