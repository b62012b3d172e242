// Pairs as rows of numbers.
#pragma once

#include "exact_view.hpp"

namespace compare {

enum class pair_kind { ball_ball, ball_plane, ball_wall };

// Of ball a the position, velocity, radius and inverse mass; then the same of ball b, or the plane's point and normal,
// or the wall's corner and edges.
struct pair_numbers {
    pair_kind kind;
    std::vector<exact_view> numbers;
};

struct pair_list {
    int dimension = 0;
    std::vector<pair_numbers> pairs;
};

} // namespace compare
