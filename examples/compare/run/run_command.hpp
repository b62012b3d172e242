// `graze-compare run`: proves a scene's sequence of collisions, runs every number type beside it, tells.
#pragma once

#include "../progress.hpp"
#include "run_options.hpp"

#include <string>

namespace compare::run {

// What has been found is printed, and written, also where the certified run ended early. Returns whether it got to the
// end that was asked for. Throws input_error.
[[nodiscard]] bool run_scene(const run_options& options, const std::string& command, const progress_line& line);

} // namespace compare::run
