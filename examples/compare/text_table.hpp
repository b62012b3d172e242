// Aligned columns of text, and short forms of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace compare {

class text_table {
  public:
    // Adds a column. left: align it to the left.
    void column(std::string heading, bool left = false);
    // Adds a heading over columns first .. first + count - 1.
    void span(std::string heading, std::size_t first, std::size_t count);
    void line(std::vector<std::string> cells);
    void gap(); // adds an empty line
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

// The width of UTF-8 text on a terminal, if it has no wide or combining characters.
[[nodiscard]] std::size_t width_of(const std::string& text);

// The text broken at spaces into lines of at most `width` where possible, each after `indent`.
[[nodiscard]] std::string wrapped(const std::string& text, const std::string& indent = "", std::size_t width = 110);

// In about six characters at most: 0, 0.50, 17, 4.1e5, 3e-17, inf.
[[nodiscard]] std::string short_number(double x);

// Two different numbers with as many digits as it takes to tell them apart: 1.92e12 and 1.93e12.
[[nodiscard]] std::pair<std::string, std::string> told_apart(double x, double y);

// A count: 850, 12.3k, 1.20M.
[[nodiscard]] std::string short_count(double x);

// 850 ns, 12.3 µs, 1.20 ms, 2.40 s.
[[nodiscard]] std::string short_time(double nanoseconds);

} // namespace compare
