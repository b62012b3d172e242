// From what gnuplot draws to what a page holds.
#pragma once

#include "picture.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace compare::report {

// What stands in a script for a text and for a colour.
[[nodiscard]] std::string mark_of_text(std::size_t index);
[[nodiscard]] std::string mark_of_colour(ink role);

// gnuplot's SVG as an element to stand in a page: marks exchanged for escaped texts and CSS variables, without ids,
// references, scripts, fonts of its own and empty groups. Throws gnuplot_error if it is not the SVG that is expected.
[[nodiscard]] std::string coloured(const std::string& drawing, const std::string& name, const std::string& description,
                                   const std::vector<std::string>& texts);

} // namespace compare::report
