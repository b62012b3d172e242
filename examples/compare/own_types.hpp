// The user's number types and formulas, listed beside all others.
#pragma once

#include "solver.hpp"

namespace compare {

// Each program defines it: in graze-compare it is empty, elsewhere it lists what graze_add_compare_program was given.
[[nodiscard]] std::vector<measurable> own_types();

} // namespace compare
