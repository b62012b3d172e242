// A bounded, two-sided wall: a segment in the plane, a parallelogram in space.
#pragma once

#include <graze/linear/vec.hpp>

#include <array>

namespace graze::inline v0_1 {

// The points corner + Σ λ_i edge_i with 0 <= λ_i <= 1. The edges are not zero and not parallel.
template <int N, class T = double>
struct wall {
    vec<N, T> corner;
    std::array<vec<N, T>, N - 1> edge;
};

} // namespace graze::inline v0_1
