// The truth for a pair: graze::solve in exact rationals, with everything else in Q(√D).
#pragma once

#include "border.hpp"
#include "true_value.hpp"

#include <graze/formula/encounter.hpp>
#include <graze/formula/wall_encounter.hpp>

#include <optional>
#include <vector>

namespace compare {

// The balls' masses, up to a common factor, and their velocities before the collision. An infinite mass absorbs
// momentum and, if it moves, energy, which are then not conserved.
struct before_impact {
    int dimension = 0;
    bool momentum = false, energy = false; // whether each is conserved
    wide mass_a = 1, mass_b = 0;
    std::vector<wide> velocities; // of a and, if there are two balls, of b
};

struct truth {
    pair_kind kind = pair_kind::ball_ball;
    graze::encounter what = graze::encounter::recede;
    graze::feature where = graze::feature::face; // of a wall, with the index of its edge or corner
    int index = 0;
    std::optional<true_value> discriminant; // of two balls, and of an edge or corner that is hit or grazed
    // The rest is for collisions only. Vectors are laid end to end: the components of a, then those of b.
    true_value time;
    std::vector<true_value> positions, velocities;
    before_impact before;
    // Relative condition numbers: Σ |x ∂f/∂x| / |f| over the inputs x. Absent if f is 0 or there is no time; infinite
    // for the time of a graze.
    std::optional<double> time_condition, discriminant_condition;
    border_distances borders;
};

template <int N>
[[nodiscard]] truth truth_of(const problem<N>& pair);

} // namespace compare
