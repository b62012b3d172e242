// All number types that this program was built with.
#pragma once

#include "results.hpp"
#include "solver.hpp"

#include <string>
#include <vector>

namespace compare {

// From the cheapest to the dearest, more or less. Another name of a type has no solver.
[[nodiscard]] std::vector<measurable> all_types();

// Those whose library was not there when the program was built.
[[nodiscard]] std::vector<missing_type> missing_types();

} // namespace compare
