// The report of a comparison: one HTML page that needs nothing else.
#pragma once

#include "results.hpp"

#include <string>

namespace compare {

// Writes it to path, whole or not at all. Throws std::runtime_error that says what failed.
void write_report(const results& found, const std::string& path);

} // namespace compare
