// The report's tables. On a narrow screen each row becomes a block, with the headings beside the values.
#pragma once

#include "../results.hpp"

#include <string>
#include <vector>

namespace compare::report {

// Heads and cells are HTML, so escape what comes from outside. The first column names its row.
[[nodiscard]] std::string table(const std::string& style, const std::vector<std::string>& heads,
                                const std::vector<std::vector<std::string>>& rows,
                                const std::vector<std::string>& ids = {}); // the rows' ids

[[nodiscard]] std::string groups_table(const results& found);
[[nodiscard]] std::string types_table(const results& found);
// For each group and number of digits: the cheapest type that decides correctly and has these digits, and its cost.
[[nodiscard]] std::string matrix_table(const results& found);
// All rows of one group.
[[nodiscard]] std::string rows_table(const results& found, const group_information& group);
// Wrong and open decisions by kind: a row for each group, type and variant that has any; empty if there are none.
[[nodiscard]] std::string decisions_table(const results& found);
// How wide the times of interval types are, and whether they enclose the truth; empty without such types.
[[nodiscard]] std::string intervals_table(const results& found);
// The worst error of the times by hardness, a column for each line of the pictures; empty without hardness.
[[nodiscard]] std::string hardness_table(const results& found, const group_information& group);

} // namespace compare::report
