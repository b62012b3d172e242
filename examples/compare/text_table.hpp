// Columns of text that line up, and short forms of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace compare {

class text_table {
  public:
    // A column's heading; left: aligned to the left.
    void column(std::string heading, bool left = false);
    // A heading over columns first .. first + count - 1.
    void span(std::string heading, std::size_t first, std::size_t count);
    void line(std::vector<std::string> cells);
    void gap(); // an empty line
    [[nodiscard]] std::string text() const;

  private:
    struct heading_over {
        std::string text;
        std::size_t first, count;
    };
    std::vector<std::string> headings_;
    std::vector<bool> left_;
    std::vector<heading_over> spans_;
    std::vector<std::vector<std::string>> lines_;
};

// The width on a terminal of UTF-8 text without wide or combining characters.
[[nodiscard]] std::size_t width_of(const std::string& text);

// Broken at spaces into lines of at most `width` where that is possible, each after `indent`.
[[nodiscard]] std::string wrapped(const std::string& text, const std::string& indent = "", std::size_t width = 110);

// In at most six characters or so: 0, 0.50, 17, 4.1e5, 3e-17, inf.
[[nodiscard]] std::string short_number(double x);

// 850, 12.3k, 1.20M.
[[nodiscard]] std::string short_nanoseconds(double x);

} // namespace compare
