// The measurement itself: every type on every group.
#pragma once

#include "group.hpp"
#include "method.hpp"
#include "progress.hpp"

#include <vector>

namespace compare {

// A row for each method of the plan, without the names of type and group. Empty if interrupted.
[[nodiscard]] std::vector<row> measure(const measurable& type, const group& pairs, const measurement_plan& plan);

// Adds the types and their rows, in the order of the types, to those already there. If interrupted, it lists what was
// not measured under `missing`.
void measure_all(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                 const measurement_plan& plan, const progress_line& line);

} // namespace compare
