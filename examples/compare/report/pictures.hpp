// The report's pictures, each as an <svg> element, or empty if the results have nothing to draw. All of them throw
// gnuplot_error.
#pragma once

#include "../results.hpp"

#include <string>

namespace compare::report {

// narrow: 360 pixels, for a telephone held upright; wide: 1040. Both are shown at about their own size.
enum class format { wide, narrow };

// Nanoseconds against the largest relative error of the time. Every type, variant and root is a point.
[[nodiscard]] std::string speed_picture(const results& found, format size);

// Nanoseconds against the share of the answers that are not right to the last bit.
[[nodiscard]] std::string exactness_picture(const results& found, format size);

// For one group with a hardness: bits lost against k, and how many of them the conditioning alone explains. keyed: draw
// a key below, for pictures outside a page.
[[nodiscard]] std::string hardness_picture(const results& found, const group_information& group, quantity what,
                                           bool keyed = false);

// For one group: the share of the times whose error is at most x.
[[nodiscard]] std::string distribution_picture(const results& found, const group_information& group,
                                               bool keyed = false);

// Wrong and open decisions: a row for each type and variant, a column for each group.
[[nodiscard]] std::string decisions_picture(const results& found, format size);

// The digits wanted, the cheapest type for them, and its cost.
[[nodiscard]] std::string matrix_picture(const results& found, format size);

} // namespace compare::report
