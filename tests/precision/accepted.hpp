// The accepted figures: a text file for each quantity, with a line for each variant, type and family, sorted.
#pragma once

#include "measure.hpp"

#include <filesystem>

namespace precision {

// Figures as in a line: errors have six significant digits.
struct accepted_line {
    figures accepted;
    bool expected_to_fail = false; // the line begins with '!': worse figures are known, and better ones are an error
};

using accepted_figures = std::map<key, accepted_line>;

// Reads the quantities' files that exist. Throws std::runtime_error with file and line if one cannot be read.
[[nodiscard]] accepted_figures read_accepted(const std::filesystem::path& folder);

// The file of one quantity, with the command that made it. Formulas that promise correct rounding have no line.
[[nodiscard]] std::string text_of(quantity q, const accepted_figures& lines, const std::string& command);

// An error as the files write it, read back.
[[nodiscard]] double as_told(double error);

enum class update { no, renewed, all };

// Writes what would change: beside each file, as *.accepted.new, or instead of it. Lines of types that were not
// measured, and lines that are expected to fail, stay. Returns the files that were written.
std::vector<std::filesystem::path> write_accepted(const std::filesystem::path& folder, const accepted_figures& before,
                                                  const all_figures& measured, update how, const std::string& command);

} // namespace precision
