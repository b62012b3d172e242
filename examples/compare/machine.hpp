// The machine on which a comparison ran.
#pragma once

#include "results.hpp"

namespace compare {

[[nodiscard]] machine_information this_machine();

} // namespace compare
