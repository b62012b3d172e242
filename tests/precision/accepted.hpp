// The accepted figures: a text file for each quantity, with a line for each variant, type and family, sorted.
#pragma once

#include "measure.hpp"

#include <filesystem>

namespace precision {

// Figures as a line tells them: errors with six significant digits.
struct accepted_line {
    figures accepted;
    bool expected_to_fail = false; // the line begins with '!': worse figures are known, and better ones are an error
};

using accepted_figures = std::map<key, accepted_line>;

// Of the quantities' files that are there. std::runtime_error with file and line for one that cannot be read.
[[nodiscard]] accepted_figures read_accepted(const std::filesystem::path& folder);

// Of one quantity, with the command that made it; correctly rounded formulas have no line.
[[nodiscard]] std::string text_of(quantity q, const accepted_figures& lines, const std::string& command);

// An error as the files tell it, and back.
[[nodiscard]] double as_told(double error);

enum class update { no, renewed, all };

// Writes what would change: beside each file, as *.accepted.new, or in its place. Keys of types that were not measured
// keep their lines, and so do those that are expected to fail. Returns the files that were written.
std::vector<std::filesystem::path> write_accepted(const std::filesystem::path& folder, const accepted_figures& before,
                                                  const all_figures& measured, update how, const std::string& command);

} // namespace precision
