// Columns of text that line up, and short forms of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
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

// Two numbers that differ, with as many digits as it takes to see that: 1.92e12 and 1.93e12.
[[nodiscard]] std::pair<std::string, std::string> told_apart(double x, double y);

// A number of things: 850, 12.3k, 1.20M.
[[nodiscard]] std::string short_count(double x);

// 850 ns, 12.3 µs, 1.20 ms, 2.40 s.
[[nodiscard]] std::string short_time(double nanoseconds);

} // namespace compare
