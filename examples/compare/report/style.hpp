// The page's style sheet.
#pragma once

#include <string>

namespace compare::report {

// The colours and what every picture needs, in a page or standing alone.
[[nodiscard]] std::string picture_style();

// The same and the style of the page around the pictures: for telephones, desktops, dark mode and paper.
[[nodiscard]] std::string style();

} // namespace compare::report
