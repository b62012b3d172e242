// Shapes with small whole coordinates, so that tangents, ties and degenerate cases are common.
#pragma once

#include "../property.hpp"

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

#include <cstdlib>

namespace draw {

// RapidCheck tries 100 cases unless RC_PARAMS says otherwise.
inline const int more_cases = setenv("RC_PARAMS", "max_success=1000", 0);

inline int whole(int from, int to) { return property::in_range(from, to + 1); }

template <int N>
graze::vec<N, int> point(int limit) {
    return graze::make_vec<N>([&](int) { return whole(-limit, limit); });
}

template <int N>
bool is_zero(const graze::vec<N, int>& x) {
    for (int i = 0; i < N; ++i) {
        if (x[i] != 0) {
            return false;
        }
    }
    return true;
}

template <int N>
graze::vec<N, int> direction(int limit) {
    const auto x = point<N>(limit);
    PROPERTY_PRE(!is_zero(x));
    return x;
}

template <int N>
graze::ball<N, int> ball() {
    const int limit = whole(1, 6);
    return {point<N>(limit), point<N>(2), whole(0, 5), whole(1, 3)};
}

template <int N>
graze::plane<N, int> plane() {
    return {point<N>(3), direction<N>(3)};
}

inline bool are_parallel(const graze::vec<3, int>& x, const graze::vec<3, int>& y) {
    return x[0] * y[1] == x[1] * y[0] && x[1] * y[2] == x[2] * y[1] && x[2] * y[0] == x[0] * y[2];
}

template <int N>
struct ball_and_wall {
    graze::ball<N, int> ball;
    graze::wall<N, int> wall;
};

// Half of the walls in space lie in a plane of coordinates, along which half of the balls then move.
template <int N>
ball_and_wall<N> ball_with_wall() {
    ball_and_wall<N> pair{ball<N>(), {point<N>(2), {}}};
    for (auto& e : pair.wall.edge) {
        e = direction<N>(3);
    }
    if constexpr (N == 3) {
        const int flat = whole(0, 3);
        if (flat < 2) {
            pair.wall.edge[0][2] = pair.wall.edge[1][2] = 0;
            pair.wall.corner[2] = 0;
            pair.ball.velocity[2] *= flat;
        }
        PROPERTY_PRE(!are_parallel(pair.wall.edge[0], pair.wall.edge[1]));
    }
    return pair;
}

} // namespace draw
