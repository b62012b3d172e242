// All number types that this program was built with.
#pragma once

#include "results.hpp"
#include "solver.hpp"

#include <string>
#include <vector>

namespace compare {

// Roughly from the cheapest to the dearest. An alias has no solver.
[[nodiscard]] std::vector<measurable> all_types();

// The types whose library was not found when the program was built.
[[nodiscard]] std::vector<missing_type> missing_types();

} // namespace compare
