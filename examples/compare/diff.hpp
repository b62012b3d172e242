// The differences of two comparisons, row by row.
#pragma once

#include "results.hpp"

#include <string>
#include <vector>

namespace compare {

struct difference {
    std::vector<std::string> worse, better, slower, faster; // a line each; times only inform
    std::vector<std::string> only_old, only_new;            // rows that the other one lacks
    std::vector<std::string> not_comparable;                // rows measured on different pairs
    std::size_t same = 0;                                   // rows without any change but of time
    std::size_t compared = 0;
};

// Rows are matched by group, type, variant and root. Worse is: more wrong or open decisions, a larger largest or median
// error, fewer correctly rounded values, or less conserved momentum or energy.
[[nodiscard]] difference compare_results(const results& before, const results& after);

[[nodiscard]] std::string to_text(const difference& d);

} // namespace compare
