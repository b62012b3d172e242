// The report of a comparison: one HTML page that needs nothing else.
#pragma once

#include "results.hpp"

#include <string>

namespace compare {

// Writes it to path, whole or not at all. Throws std::runtime_error that says what failed.
void write_report(const results& found, const std::string& path);

// Writes the report's picture of speed against error alone, as an SVG file that shows its own light and dark colours.
// Whole or not at all; throws std::runtime_error, also where gnuplot is missing.
void write_picture(const results& found, const std::string& path);

} // namespace compare
