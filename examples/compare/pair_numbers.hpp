// Pairs as rows of numbers.
#pragma once

#include "exact_view.hpp"

#include <array>

namespace compare {

enum class pair_kind { ball_ball, ball_plane, ball_wall, ball_triangle };
inline constexpr std::array<const char*, 4> pair_kind_keys = {"ball_ball", "ball_plane", "ball_wall", "ball_triangle"};

[[nodiscard]] constexpr const char* key_of(pair_kind kind) { return pair_kind_keys[static_cast<std::size_t>(kind)]; }
// Whether the ball's partner has a face, edges and corners.
[[nodiscard]] constexpr bool has_features(pair_kind kind) { return kind >= pair_kind::ball_wall; }

// numbers: position, velocity, radius and inverse mass of ball a, then the same of ball b, the plane's point and
// normal, or the corner and the edges of the wall or triangle.
struct pair_numbers {
    pair_kind kind;
    std::vector<exact_view> numbers;
};

struct pair_list {
    int dimension = 0;
    std::vector<pair_numbers> pairs;
};

} // namespace compare
