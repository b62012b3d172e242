// The picture book: a page and pictures for each set of results, and a first page with links to them.
#pragma once

#include "fallback.hpp"

#include <results.hpp>

#include <string>
#include <utility>
#include <vector>

namespace peers {

struct chapter {
    std::string name; // of its files
    compare::results found;
};

// Writes folder/index.html, folder/NAME.html, folder/NAME-speed.svg and so on, and folder/fallback.svg. Creates the
// folder. Throws std::runtime_error, which names what cannot be written or drawn.
void write_book(const std::string& folder, const std::vector<chapter>& chapters,
                const std::vector<fallback_rate>& rates, const std::string& command);

} // namespace peers
