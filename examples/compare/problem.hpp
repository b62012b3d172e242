// The pairs on which the program compares, with exact rational data, whatever their source.
#pragma once

#include "pair_numbers.hpp"

#include <graze/number/adapter/boost.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace compare {

using exact = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

// A ball with the inverse of its mass, in which 0 is an infinite mass. shape.mass is not used.
template <int N>
struct exact_ball {
    graze::ball<N, exact> shape;
    exact inverse_mass;
};

template <int N>
struct exact_scene {
    std::vector<exact_ball<N>> balls;
    std::vector<graze::plane<N, exact>> planes;
    std::vector<graze::wall<N, exact>> walls;
    std::vector<graze::triangle<exact>> triangles = {}; // in space
    std::vector<std::uint8_t> inner_edges = {};         // of each triangle, as in graze::scene; used by runs only
    graze::vec<N, exact> period = {};                   // used by runs only

    [[nodiscard]] bool is_periodic() const { return graze::squared_norm(period) != 0; }
};

// One pair: a and, depending on kind, b, plane or wall. A triangle is the half of `wall` at its corner. group: the name
// of the scene or the family. hardness: the family's k, or -1.
template <int N>
struct problem {
    pair_kind kind = pair_kind::ball_ball;
    exact_ball<N> a, b;
    graze::plane<N, exact> plane;
    graze::wall<N, exact> wall;
    std::string group;
    int hardness = -1;
    std::string name = {};  // "ball 3 and wall 0"; of a family "pair 17"
    std::size_t number = 0; // counted across all groups, from 1
};

} // namespace compare
