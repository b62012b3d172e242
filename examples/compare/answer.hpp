// From rows to answers: the best fronts, the cheapest type for each precision, and one sentence.
#pragma once

#include "results.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace compare {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// A choice of type, variant and root over all groups in which it was measured.
struct overall {
    choice how;
    std::size_t wrong = 0;     // or undecided
    std::size_t evaluated = 0; // pairs
    std::size_t times = 0;     // of τ and the crossings that were measured
    double fewest_bits = 0;    // of these times; infinite where all are exact, or none is due
    bool exact = false;        // every value of every quantity was without error, and no decision wrong
    bool complete = false;     // measured in every group
};

// In the order of the rows.
[[nodiscard]] std::vector<overall> overall_of(const results& found);

// The largest error of τ and the crossings, in units of the last place.
[[nodiscard]] double largest_time_error(const row& r);

// Sets on_front of every row, and found's matrix, good_enough, exact and sentence.
void draw_conclusions(results& found);

} // namespace compare
