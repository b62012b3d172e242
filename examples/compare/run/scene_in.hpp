// A scene in a run's number type.
#pragma once

#include "../problem.hpp"

#include <graze/scene/scene.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace compare::run {

// Owns the arrays of a graze::scene.
template <int N, class T>
struct owned_scene {
    std::vector<graze::ball<N, T>> balls;
    std::vector<graze::plane<N, T>> planes;
    std::vector<graze::wall<N, T>> walls;
    graze::vec<N, T> period = graze::make_vec<N>([](int) { return T(0); });
    std::vector<graze::triangle<T>> triangles = {}; // in space
    std::vector<std::uint8_t> inner_edges = {};     // of each triangle

    [[nodiscard]] graze::scene<N, T> view() const {
        graze::scene<N, T> s{balls, planes, walls};
        s.period = period;
        if constexpr (N == 3) {
            s.triangles = triangles;
            s.inner_edges = inner_edges;
        }
        return s;
    }
};

// Converts every number by `convert`; an infinite mass becomes `infinity`.
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
        result.walls.push_back({vector_in(w.corner), {}});
        std::transform(w.edge.begin(), w.edge.end(), result.walls.back().edge.begin(), vector_in);
    }
    if constexpr (N == 3) {
        for (const graze::triangle<exact>& t : scene.triangles) {
            result.triangles.push_back({vector_in(t.corner), {vector_in(t.edge[0]), vector_in(t.edge[1])}});
        }
        result.inner_edges = scene.inner_edges;
    }
    return result;
}

} // namespace compare::run
