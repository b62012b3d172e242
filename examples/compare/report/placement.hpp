// Places names beside points so that they do not cover each other.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace compare::report {

// In pixels from the top left.
struct box {
    double left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] bool meets(const box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// The width of a text of this size, roughly, in a sans-serif font.
[[nodiscard]] double width_of(const std::string& text, double size);

// The text, shortened at its end if it is wider.
[[nodiscard]] std::string fitted(std::string text, double size, double width);

struct placed {
    double x = 0, y = 0; // on the text's middle line
    std::string align;   // "left", "center" or "right": which part of the text is at x
};

class placement {
  public:
    // Names stay within area and off the points.
    placement(const box& area, std::vector<box> points) : area_(area), taken_(std::move(points)) {}

    // The free place nearest to the point at x, y. If there is none, the nearest that is within the area.
    [[nodiscard]] placed place(const std::string& text, double size, double x, double y);

  private:
    box area_;
    std::vector<box> taken_;
};

} // namespace compare::report
