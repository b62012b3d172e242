// Encounters decided in integers: much faster than in rationals, which reduce a fraction in every operation.
#pragma once

#include "rounding.hpp"

#include <graze/formula/encounter.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <vector>

namespace compare {

// A scene in integers: lengths and velocities are multiplied by their common denominators, each normal by its own. That
// changes no encounter.
template <int N>
struct integer_scene {
    std::vector<graze::ball<N, exact_integer>> balls; // masses are not used
    std::vector<graze::plane<N, exact_integer>> planes;
    std::vector<graze::wall<N, exact_integer>> walls;
    std::vector<graze::triangle<exact_integer>> triangles;
};

template <int N>
[[nodiscard]] integer_scene<N> to_integers(const exact_scene<N>& scene);

template <int N>
[[nodiscard]] graze::encounter encounter_of_balls(const graze::ball<N, exact_integer>& a,
                                                  const graze::ball<N, exact_integer>& b);
template <int N>
[[nodiscard]] graze::encounter encounter_with_plane(const graze::ball<N, exact_integer>& b,
                                                    const graze::plane<N, exact_integer>& p);
template <int N>
[[nodiscard]] graze::encounter encounter_with_wall(const graze::ball<N, exact_integer>& b,
                                                   const graze::wall<N, exact_integer>& w);
[[nodiscard]] graze::encounter encounter_with_triangle(const graze::ball<3, exact_integer>& b,
                                                       const graze::triangle<exact_integer>& t);

} // namespace compare
