// Results for the terminal.
#pragma once

#include "results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace compare {

struct table_options {
    std::vector<quantity> quantities; // a table for each; if empty, one of all times: τ and crossings
    bool one_pair = false;            // print the one pair in full
    bool every_row = false;           // also rows that say little: every variant of exact types, printed roots
};

[[nodiscard]] std::string to_text(const results& found, const table_options& options);

} // namespace compare
