// A dot for every pair: the data with which the page's script draws them and opens a row's worst and wrong pairs.
#pragma once

#include "../results.hpp"

#include <string>

namespace compare::report {

// The data as JSON for a <script>; empty if no group knows its pairs. A group with more than `most` pairs is thinned:
// it keeps the pairs on which a row is worst or wrong, the worst of each line, and every n-th of the others.
[[nodiscard]] std::string dots_data(const results& found, std::size_t most = 3000);

// A remark about the thinning: "2,000 of 124,750 pairs ..."; empty if all pairs are drawn.
[[nodiscard]] std::string dots_remark(const results& found, std::size_t most = 3000);

} // namespace compare::report
