// Walls and triangles.
#pragma once

#include "certified.hpp"

#include <graze/shape/triangle.hpp>

#include <type_traits>

namespace compare::run {

// A wall or a triangle.
template <class S>
concept flat_shape = requires(const S& s) {
    s.edge;
};

template <flat_shape S>
inline constexpr bool is_triangle = std::is_same_v<S, graze::triangle<certified>>;

} // namespace compare::run
