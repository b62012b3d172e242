// The pairs that types are wrong on, and at their worst on: in words, as files, and as commands that show them again.
#pragma once

#include "quoted.hpp"
#include "results.hpp"

#include <filesystem>
#include <string>

namespace compare {

// The command that measures this pair alone in the row's type and form.
[[nodiscard]] std::string repeat_command(const results& found, const row& r, std::size_t pair);

// "wrong on hit or miss, nearest to the border"; "largest error of the time".
[[nodiscard]] std::string in_words(const extreme_pair& e);

// For the terminal: the wrong pairs, and each type's worst one. Empty if every type is right everywhere.
[[nodiscard]] std::string extremes_text(const results& found);

// For the terminal: every number of the one pair that was measured, and what each row says of it.
[[nodiscard]] std::string one_pair_text(const results& found);

// Writes a scene file for each pair, pair-NUMBER.json, and a list of them all, pairs.txt. The folder is made where it
// is missing. Throws std::runtime_error that names what cannot be written.
void write_pairs(const results& found, const std::filesystem::path& folder);

} // namespace compare
