// Whether two series of repeated times differ by more than chance.
#pragma once

#include <vector>

namespace compare {

// The probability, if both series come from one distribution, of ranks at least as uneven as theirs: the two-sided
// Mann–Whitney U test with ties, by the normal approximation with a correction for continuity (Mann and Whitney 1947).
// 1 if a series has fewer than three values, since these say nothing.
[[nodiscard]] double probability_of_no_difference(const std::vector<double>& x, const std::vector<double>& y);

} // namespace compare
