// A fluid of hard spheres in a cube, generated from integers alone, so that it is the same everywhere.
#pragma once

#include <graze/scene/scene.hpp>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

template <int N>
struct fluid {
    std::vector<graze::ball<N>> balls;
    std::vector<graze::plane<N>> planes;

    [[nodiscard]] graze::scene<N> scene() const { return {balls, planes, {}}; }
};

// Balls of diameter and mass 1 on a lattice of spacing 5/4, with velocities below 1 along each axis, in a cube of whole
// lattice cells.
template <int N>
[[nodiscard]] fluid<N> make_fluid(int count, std::uint64_t seed) {
    constexpr double cell = 1.25;
    const auto sites = [](int side) {
        int product = side;
        for (int i = 1; i < N; ++i) {
            product *= side;
        }
        return product;
    };
    int side = 1;
    while (sites(side) < count) {
        ++side;
    }
    std::mt19937_64 random(seed);
    fluid<N> f;
    std::array<int, N> site{};
    for (int i = 0; i < count; ++i) {
        graze::ball<N> b{};
        for (int axis = 0; axis < N; ++axis) {
            b.position[axis] = (site[static_cast<std::size_t>(axis)] + 0.5) * cell;
            b.velocity[axis] = static_cast<double>(static_cast<std::int64_t>(random() >> 43) - (1 << 20)) * 0x1p-20;
        }
        b.radius = 0.5;
        b.mass = 1;
        f.balls.push_back(b);
        for (std::size_t axis = 0; axis < N && ++site[axis] == side; ++axis) {
            site[axis] = 0;
        }
    }
    for (int axis = 0; axis < N; ++axis) {
        graze::plane<N> p{};
        p.normal[axis] = 1;
        f.planes.push_back(p);
        p.point[axis] = side * cell;
        f.planes.push_back(p);
    }
    return f;
}
