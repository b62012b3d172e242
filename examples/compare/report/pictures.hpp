// The report's pictures, each as an <svg> element, or empty when the results have nothing to draw. All throw
// gnuplot_error.
#pragma once

#include "../results.hpp"

#include <string>

namespace compare::report {

// narrow: for a telephone held upright, drawn for 360 pixels; wide: for 1040. Both are read at about their own size.
enum class format { wide, narrow };

// Nanoseconds against the largest relative error of the time of impact, every type, variant and root form a point.
[[nodiscard]] std::string speed_picture(const results& found, format size);

// Nanoseconds against the share of the answers that are not right to the last bit.
[[nodiscard]] std::string exactness_picture(const results& found, format size);

// For one group with a hardness: bits lost against k, with what the conditioning alone explains.
// keyed: its lines are named beneath it, where no page does that.
[[nodiscard]] std::string hardness_picture(const results& found, const group_information& group, quantity what,
                                           bool keyed = false);

// For one group: which share of the times have at most which error.
[[nodiscard]] std::string distribution_picture(const results& found, const group_information& group,
                                               bool keyed = false);

// Wrong and open decisions, a row a type and variant, a column a group.
[[nodiscard]] std::string decisions_picture(const results& found, format size);

// Digits wanted, the cheapest type and its cost.
[[nodiscard]] std::string matrix_picture(const results& found, format size);

} // namespace compare::report
