// The measurement itself: every type on every group.
#pragma once

#include "type_list.hpp"

#include <vector>

namespace compare {

// Fills in types and rows. progress: tell the standard error stream what is being measured.
void measure_all(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                 const measurement_plan& plan, bool progress);

} // namespace compare
