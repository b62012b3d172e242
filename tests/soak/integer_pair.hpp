// A pair in integers, and every number of a pair times a power of two.
#pragma once

#include "../../examples/families/families.hpp"

#include <array>
#include <cstdint>

namespace families {

// A ball at x + w with velocity v + u and, depending on kind, another ball at x with velocity v, a plane through x
// whose normal is edge[0], or a wall with a corner at x.
template <int N>
struct integer_pair {
    integers<N> x{}, v{}, w{}, u{};
    std::array<integers<N>, N - 1> edge{};
    std::int64_t radius = 0, other_radius = 0;
};

// In units of 2^length, 2^velocity and 2^normal.
template <int N>
[[nodiscard]] constexpr pair_of_doubles<N> make_pair(pair_kind kind, const integer_pair<N>& m, int length, int velocity,
                                                     int normal) {
    pair_of_doubles<N> pair;
    pair.kind = kind;
    pair.a.position = make_vector<N>(sum<N>(m.x, m.w), length);
    pair.a.velocity = make_vector<N>(sum<N>(m.v, m.u), velocity);
    pair.a.radius = make_double(m.radius, length);
    pair.b.position = pair.plane.point = pair.wall.corner = make_vector<N>(m.x, length);
    pair.b.velocity = make_vector<N>(m.v, velocity);
    pair.b.radius = make_double(m.other_radius, length);
    pair.plane.normal = make_vector<N>(m.edge[0], normal);
    for (std::size_t i = 0; i < m.edge.size(); ++i) {
        pair.wall.edge[i] = make_vector<N>(m.edge[i], length);
    }
    return pair;
}

// Every length times 2^length, every velocity times 2^velocity, every normal times 2^normal.
template <int N>
constexpr void scale(pair_of_doubles<N>& pair, int length, int velocity, int normal) {
    const auto all = [](graze::vec<N, double>& x, int power) {
        for (int i = 0; i < N; ++i) {
            x[i] = times_power_of_two(x[i], power);
        }
    };
    for (graze::ball<N, double>* b : {&pair.a, &pair.b}) {
        all(b->position, length);
        all(b->velocity, velocity);
        b->radius = times_power_of_two(b->radius, length);
    }
    all(pair.plane.point, length);
    all(pair.plane.normal, normal);
    all(pair.wall.corner, length);
    for (auto& e : pair.wall.edge) {
        all(e, length);
    }
}

// Components below 2^bits, not all of them 0.
template <int N>
[[nodiscard]] constexpr integers<N> random_direction(random& r, int bits) {
    integers<N> x = random_vector<N>(r, bits);
    x[r.below(N)] = r.either_sign(r.in(1, (std::int64_t{1} << bits) - 1));
    return x;
}

// Edges that span a wall, of integers below 2^bits, bits <= 30.
template <int N>
[[nodiscard]] constexpr std::array<integers<N>, N - 1> random_edges(random& r, int bits) {
    std::array<integers<N>, N - 1> edge{random_direction<N>(r, bits)};
    if constexpr (N == 3) {
        do {
            edge[1] = random_direction<3>(r, bits);
        } while (parallel(edge[0], edge[1]));
    }
    return edge;
}

} // namespace families
