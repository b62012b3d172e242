// The report of a comparison: one HTML page that needs nothing else.
#pragma once

#include "diff.hpp"
#include "results.hpp"

#include <string>
#include <vector>

namespace compare {

// Writes it to path, whole or not at all. Throws std::runtime_error that says what failed.
void write_report(const results& found, const std::string& path);

// Writes a picture of a page, an <svg> element, as a file that shows its own light and dark colours and says which
// command made it. Whole or not at all; throws std::runtime_error.
void write_picture_file(std::string svg, std::string command, const std::string& path);

// Writes the report's picture of speed against error alone, as such a file. Throws std::runtime_error, also where
// gnuplot is missing.
void write_picture(const results& found, const std::string& path);

// All pictures of the report as such files: stem + "speed.svg", "exactness.svg", "digits.svg", "decisions.svg", and
// "distribution-" and "hardness-" with the name of each group. Those that have nothing to draw are left out. Returns
// the paths. Throws std::runtime_error.
std::vector<std::string> write_pictures(const results& found, const std::string& stem);

// The differences of the last two results as one page, and the history of all; `found` is compare_results of these two.
// names: what each is called. Throws std::runtime_error.
void write_diff_report(const std::vector<results>& all, const std::vector<std::string>& names, const difference& found,
                       const std::string& path);

} // namespace compare
