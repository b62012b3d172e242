// The pairs that the command line asks for.
#pragma once

#include "group.hpp"
#include "options.hpp"
#include "progress.hpp"

#include <vector>

namespace compare {

// Draws or reads the pairs and solves them exactly. Throws input_error.
[[nodiscard]] std::vector<group> groups_of(const options& o, const progress_line& line);

} // namespace compare
