// A picture that gnuplot draws and that a page colours.
//
// gnuplot gets placeholders instead of the page's texts and colours. In its drawing they are replaced by the escaped
// texts and by CSS variables. So no text of a scene file can become a command, and one drawing serves light, dark and
// paper.
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

// The variable's name: "--text" and so on.
[[nodiscard]] const char* variable_of(ink colour);

class picture {
  public:
    // name: letters and hyphens. Sizes in CSS pixels. description: the text for readers who cannot see the picture.
    picture(std::string name, int width, int height, std::string description);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    // The part of the picture that the axes enclose, in pixels from each side.
    void margins(double left, double right, double top, double bottom);

    void add(const std::string& line) { script_ += line + '\n'; }

    // A mark for the text, in quotes: use it wherever gnuplot takes a string.
    [[nodiscard]] std::string text(const std::string& content);

    // Texts at places of the axis 'x' or 'y'.
    void tics(char axis, const std::vector<std::pair<double, std::string>>& places);

    // A mark for the colour, as gnuplot's `rgb "..."`.
    [[nodiscard]] static std::string colour(ink role);

    // Text at x, y, which are in axis units or prefixed by "graph" or "screen"; align is left, center or right.
    void label(const std::string& content, const std::string& x, const std::string& y, const std::string& align,
               ink role, double size = 12, int rotate = 0);

    // Draws it. Points that were plotted `with labels hypertext` carry their text as a <title> in <g class="point">.
    // Throws gnuplot_error.
    [[nodiscard]] std::string svg() const;

  private:
    std::string name_, description_, script_;
    int width_, height_;
    std::vector<std::string> texts_;
};

// A number in gnuplot's syntax, in full precision.
[[nodiscard]] std::string exactly(double value);

} // namespace compare::report
