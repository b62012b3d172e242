// How far a pair is from the borders where its decision changes.
//
// f(t) is the squared distance between the ball's centre and the other thing at time t, less r² (of two balls, R²). The
// signs of f'(0), f(0) and of the least f ahead decide. L² is the sum of the squares of the lengths that the formulas
// start from: |Δx|² + R², |x - point|² + r², or |x - corner|² + the edges' |e|² + r². The distances are relative:
//   receding     |f'(0)|/(2 L |Δu|): whether the two come closer
//   overlapping  |f(0)|/L²
//   hitting      |least f|/L²; where the centre goes through a wall, (ρ² + r²)/L², where ρ is the distance
//                from there to the wall's rim; for a plane, which is neither missed nor grazed, 1
#pragma once

#include "problem.hpp"

#include <graze/formula/encounter.hpp>

namespace compare {

struct border_distances {
    double receding = 1, overlapping = 1, hitting = 1;
};

template <int N>
[[nodiscard]] border_distances border_distances_of(const problem<N>& pair);

// The nearest of the borders that this encounter, which is the true one, has.
[[nodiscard]] double nearest_border(graze::encounter what, const border_distances& distances);

} // namespace compare
