// The pairs on which types are wrong or have their largest errors: in words, as files, and as commands that repeat
// them.
#pragma once

#include "quoted.hpp"
#include "results.hpp"

#include <filesystem>
#include <string>

namespace compare {

// The command that measures this pair alone in the row's type and form.
[[nodiscard]] std::string repeat_command(const results& found, const row& r, std::size_t pair);

// For example "wrong on hit or miss, nearest to the border" or "largest error of the time".
[[nodiscard]] std::string in_words(const extreme_pair& e);

// For the terminal: the wrong pairs, and each type's worst pair. Empty if every type is right everywhere.
[[nodiscard]] std::string extremes_text(const results& found);

// For the terminal: every number of the one pair that was measured, and every row's answer to it.
[[nodiscard]] std::string one_pair_text(const results& found);

// Writes a scene file for each pair, pair-NUMBER.json, and a list of all of them, pairs.txt. Creates the folder if it
// is missing. Throws std::runtime_error, which names what cannot be written.
void write_pairs(const results& found, const std::filesystem::path& folder);

} // namespace compare
