// A picture that gnuplot draws and that a page colours.
//
// gnuplot gets placeholders instead of the page's texts and colours. In gnuplot's drawing they are replaced by the
// escaped texts and by CSS variables. So no text of a scene file can become a command, and one drawing serves light and
// dark pages and paper.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace compare::report {

// The roles of colours. The style sheet has a variable for each.
enum class ink {
    text,
    muted,
    grid,
    paper,
    bad,
    open,
    best,
    one,
    two,
    three,
    four,
    five,
    six,
    seven,
};
inline constexpr int ink_count = 14;

// The name of the style sheet's variable: "--text" and so on.
[[nodiscard]] const char* variable_of(ink colour);

class picture {
  public:
    // name: letters and hyphens. Sizes are in CSS pixels. description: for readers who cannot see the picture.
    picture(std::string name, int width, int height, std::string description);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    // The distances in pixels of the axes from the picture's sides.
    void margins(double left, double right, double top, double bottom);

    void add(const std::string& line) { script_ += line + '\n'; }

    // A quoted placeholder for the text: use it wherever gnuplot takes a string.
    [[nodiscard]] std::string text(const std::string& content);

    // Labels the axis 'x' or 'y' with these texts at these places.
    void tics(char axis, const std::vector<std::pair<double, std::string>>& places);

    // A placeholder for the colour, as gnuplot's `rgb "..."`.
    [[nodiscard]] static std::string colour(ink role);

    // Text at x, y, which are in axis units or prefixed by "graph" or "screen"; align is left, center or right.
    void label(const std::string& content, const std::string& x, const std::string& y, const std::string& align,
               ink role, double size = 12, int rotate = 0);

    // Draws the picture. Points plotted `with labels hypertext` get their text as a <title> in <g class="point">.
    // Throws gnuplot_error.
    [[nodiscard]] std::string svg() const;

  private:
    std::string name_, description_, script_;
    int width_, height_;
    std::vector<std::string> texts_;
};

// A number in gnuplot's syntax, with all its digits.
[[nodiscard]] std::string exactly(double value);

} // namespace compare::report
