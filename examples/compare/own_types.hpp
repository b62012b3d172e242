// The user's number types and formulas, which stand beside all others.
#pragma once

#include "solver.hpp"

namespace compare {

// Each program defines it: graze-compare has none, others what graze_add_compare_program was given.
[[nodiscard]] std::vector<measurable> own_types();

} // namespace compare
