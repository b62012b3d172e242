// The measurement itself: every type on every group.
#pragma once

#include "progress.hpp"
#include "type_list.hpp"

#include <vector>

namespace compare {

// Fills in types and rows.
void measure_all(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                 const measurement_plan& plan, const progress_line& line);

} // namespace compare
