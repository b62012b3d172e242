// `graze-compare run`: proves a scene's sequence of collisions, runs every number type on the scene, and reports.
#pragma once

#include "../progress.hpp"
#include "run_options.hpp"

#include <string>

namespace compare::run {

// Prints and writes what was found, even if the certified run ended early. Returns whether it reached the end that was
// asked for. Throws input_error.
[[nodiscard]] bool run_scene(const run_options& options, const std::string& command, const progress_line& line);

} // namespace compare::run
