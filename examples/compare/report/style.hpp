// The page's style sheet.
#pragma once

#include <string>

namespace compare::report {

// The colours and what every picture needs, for a page or for a picture that stands alone.
[[nodiscard]] std::string picture_style();

// The same and the page around the pictures: for telephones, desks, dark rooms and paper.
[[nodiscard]] std::string style();

} // namespace compare::report
