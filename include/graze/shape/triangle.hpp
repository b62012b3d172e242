// A bounded, two-sided triangle in space.
#pragma once

#include <graze/linear/vec.hpp>

#include <array>

namespace graze::inline v0_1 {

// The points corner + λ_0·edge[0] + λ_1·edge[1], λ_i >= 0, λ_0 + λ_1 <= 1: the half of a wall at its corner. Edges are
// not zero and not parallel.
template <class T = double>
struct triangle {
    vec<3, T> corner;
    std::array<vec<3, T>, 2> edge;
};

} // namespace graze::inline v0_1
