// A scene in the numbers of a run.
#pragma once

#include "../problem.hpp"

#include <graze/scene/scene.hpp>

#include <vector>

namespace compare::run {

// Owns what a graze::scene refers to.
template <int N, class T>
struct owned_scene {
    std::vector<graze::ball<N, T>> balls;
    std::vector<graze::plane<N, T>> planes;
    std::vector<graze::wall<N, T>> walls;
    graze::vec<N, T> period = graze::make_vec<N>([](int) { return T(0); });

    [[nodiscard]] graze::scene<N, T> view() const {
        graze::scene<N, T> s{balls, planes, walls};
        s.period = period;
        return s;
    }
};

// Every number by `convert`, an infinite mass by `infinity`.
template <class T, int N, class Convert>
[[nodiscard]] owned_scene<N, T> scene_in(const exact_scene<N>& scene, const T& infinity, Convert convert) {
    const auto vector_in = [&](const graze::vec<N, exact>& x) {
        return graze::make_vec<N>([&](int i) -> T { return convert(x[i]); });
    };
    owned_scene<N, T> result;
    result.period = vector_in(scene.period);
    for (const exact_ball<N>& b : scene.balls) {
        result.balls.push_back({vector_in(b.shape.position), vector_in(b.shape.velocity), convert(b.shape.radius),
                                b.inverse_mass.is_zero() ? infinity : T(convert(b.shape.mass))});
    }
    for (const graze::plane<N, exact>& p : scene.planes) {
        result.planes.push_back({vector_in(p.point), vector_in(p.normal)});
    }
    for (const graze::wall<N, exact>& w : scene.walls) {
        graze::wall<N, T> wall{vector_in(w.corner), {}};
        for (std::size_t i = 0; i < w.edge.size(); ++i) {
            wall.edge[i] = vector_in(w.edge[i]);
        }
        result.walls.push_back(std::move(wall));
    }
    return result;
}

} // namespace compare::run
