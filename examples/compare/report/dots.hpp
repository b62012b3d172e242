// Every pair a dot: what the page's script needs to draw them and to open a row's worst and wrong pairs.
#pragma once

#include "../results.hpp"

#include <string>

namespace compare::report {

// The data as JSON for a <script>, or empty where no group knows its pairs. Of a group with more than `most` pairs,
// those that a row is worst or wrong on are kept, the worst of each line, and of the others every n-th.
[[nodiscard]] std::string dots_data(const results& found, std::size_t most = 3000);

// What is said of the thinning: "2,000 of 124,750 pairs ..."; empty where all are drawn.
[[nodiscard]] std::string dots_remark(const results& found, std::size_t most = 3000);

} // namespace compare::report
