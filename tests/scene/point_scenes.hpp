// Scenes of one point and walls on a grid, in which nearly everything happens at seams, corners, crossings and tips.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/wall.hpp>

#include <random>
#include <vector>

template <int N>
struct point_scene {
    std::vector<graze::ball<N>> point;
    std::vector<graze::wall<N>> walls;
};

// slanted: walls in any direction of the grid; otherwise along its axes and diagonals. The same on every platform.
template <int N>
[[nodiscard]] point_scene<N> any_point_scene(std::uint64_t seed, bool slanted) {
    std::mt19937_64 random(seed);
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
    };
    const auto one_in = [&](int n) { return between(1, n) == 1; };
    const auto any = [&](int most) {
        return graze::make_vec<N>([&](int) { return static_cast<double>(between(-most, most)); });
    };
    const auto zero = graze::make_vec<N>([](int) { return 0.0; });
    const auto direction = [&] {
        auto d = zero;
        while (d == zero) {
            d = any(slanted ? 3 : 1);
            if (N == 3 && one_in(2)) { // along an axis
                for (int i = 0; i < N; ++i) {
                    d[i] = between(0, 2) == i ? d[i] : 0;
                }
            }
        }
        return d;
    };
    point_scene<N> scene;
    const auto hub = any(2);                                  // a place that many walls go through
    const int flat = N == 3 && one_in(3) ? between(0, 2) : N; // across this axis through the hub most is in one plane
    const auto flattened = [&](graze::vec<N, double> x, double at) {
        if (flat < N && !one_in(4)) {
            x[flat] = at;
        }
        return x;
    };
    const int count = between(2, 7);
    for (int i = 0; i < count; ++i) {
        graze::wall<N> w{one_in(3) ? flattened(any(3), flat < N ? hub[flat] : 0) : hub, {}};
        const auto edge = [&] {
            auto e = zero;
            while (e == zero) {
                e = flattened(static_cast<double>(between(1, 2)) * direction(), 0);
            }
            return e;
        };
        w.edge[0] = edge();
        if constexpr (N == 3) {
            do {
                w.edge[1] = edge();
            } while (graze::squared_norm(graze::cross(w.edge[0], w.edge[1])) == 0);
        }
        for (auto& e : w.edge) { // it starts at the hub, ends there, or passes through
            const int place = between(0, 3);
            w.corner = place == 1 ? w.corner - e : place == 2 ? w.corner - 0.5 * e : w.corner;
            w.corner = one_in(8) ? w.corner + 2.0 * e : w.corner; // or is elsewhere on its line
        }
        scene.walls.push_back(w);
    }
    if (one_in(2)) { // a box around everything
        for (int axis = 0; axis < N; ++axis) {
            for (const double at : {-8.0, 8.0}) {
                graze::wall<N> w{graze::make_vec<N>([&](int i) { return i == axis ? at : -8.0; }), {}};
                int edge = 0;
                for (int i = 0; i < N; ++i) {
                    if (i != axis) {
                        w.edge[static_cast<std::size_t>(edge++)] =
                            graze::make_vec<N>([&](int k) { return k == i ? 16.0 : 0.0; });
                    }
                }
                scene.walls.push_back(w);
            }
        }
    }
    auto u = zero;
    while (u == zero) {
        u = one_in(3) ? flattened(any(slanted ? 3 : 1), 0) : any(slanted ? 3 : 1);
    }
    const auto aim = one_in(4) ? any(3) : hub;
    scene.point.push_back({aim - (0.5 * between(1, 8)) * u, u, 0, 1});
    return scene;
}
