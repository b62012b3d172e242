// From gnuplot's drawing to an element of a page.
#pragma once

#include "picture.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace compare::report {

// The placeholders in a script for a text and for a colour.
[[nodiscard]] std::string mark_of_text(std::size_t index);
[[nodiscard]] std::string mark_of_colour(ink role);

// Turns gnuplot's SVG into an element of a page: placeholders become escaped texts and CSS variables; ids, references,
// scripts, fonts and empty groups are removed. Throws gnuplot_error if the SVG is not as expected.
[[nodiscard]] std::string coloured(const std::string& drawing, const std::string& name, const std::string& description,
                                   const std::vector<std::string>& texts);

} // namespace compare::report
