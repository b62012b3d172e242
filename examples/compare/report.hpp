// The report of a comparison: one HTML page without other files.
#pragma once

#include "diff.hpp"
#include "results.hpp"

#include <string>
#include <vector>

namespace compare {

// Writes the report to path, whole or not at all. Throws std::runtime_error, which says what failed.
void write_report(const results& found, const std::string& path);

// Writes a picture of a page, an <svg> element, as a file with light and dark colours of its own and the command that
// made it. Whole or not at all; throws std::runtime_error.
void write_picture_file(std::string svg, std::string command, const std::string& path);

// Writes only the report's picture of speed against error, as such a file. Throws std::runtime_error, for example if
// gnuplot is missing.
void write_picture(const results& found, const std::string& path);

// Writes all pictures of the report as such files: stem + "speed.svg", "exactness.svg", "digits.svg", "decisions.svg",
// and "distribution-" and "hardness-" with the name of each group. Pictures with nothing to draw are left out. Returns
// the paths. Throws std::runtime_error.
std::vector<std::string> write_pictures(const results& found, const std::string& stem);

// Writes one page: the differences of the last two results, and the history of all. `found` is compare_results of these
// two. names: what to call each result. Throws std::runtime_error.
void write_diff_report(const std::vector<results>& all, const std::vector<std::string>& names, const difference& found,
                       const std::string& path);

} // namespace compare
