// Results for the terminal.
#pragma once

#include "results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace compare {

struct table_options {
    std::vector<quantity> quantities; // a table for each; without any, one of all times: τ and crossings
    bool one_pair = false;            // that one in full
    bool every_row = false;           // also the rows that say little: every variant of the exact types, printed roots
};

[[nodiscard]] std::string to_text(const results& found, const table_options& options);

} // namespace compare
