#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace compare {

namespace {

std::string formatted(const char* format, double x) {
    char text[64];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::size_t used = width_of(text);
    const std::string room(used < width ? width - used : 0, ' ');
    return left ? text + room : room + text;
}

std::string without_trailing_spaces(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

} // namespace

std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::string wrapped(const std::string& text, const std::string& indent, std::size_t width) {
    std::string result, line = indent;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (width_of(line) > width_of(indent) && width_of(line) + 1 + width_of(word) > width) {
            result += line + "\n";
            line = indent;
        }
        line += (line == indent ? "" : " ") + word;
        at = end + 1;
    }
    return result + line + "\n";
}

std::string short_number(double x) {
    if (std::isinf(x)) {
        return x > 0 ? "inf" : "-inf";
    }
    const double size = std::fabs(x);
    if (size == 0.0) {
        return "0";
    }
    if (size < 0.001 || size >= 99999.5) {
        std::string text = formatted(size < 0.001 ? "%.0e" : "%.1e", x);
        const auto letter = text.find('e');
        const int exponent = std::stoi(text.substr(letter + 1));
        return text.substr(0, letter) + "e" + std::to_string(exponent);
    }
    return formatted(size < 0.01 ? "%.3f" : size < 10 ? "%.2f" : size < 100 ? "%.1f" : "%.0f", x);
}

std::pair<std::string, std::string> told_apart(double x, double y) {
    std::pair<std::string, std::string> texts = {short_number(x), short_number(y)};
    for (int digits = 3; digits <= 17 && x != y && texts.first == texts.second; ++digits) {
        char first[40], second[40];
        std::snprintf(first, sizeof first, "%.*g", digits, x);
        std::snprintf(second, sizeof second, "%.*g", digits, y);
        texts = {first, second};
    }
    return texts;
}

std::string short_count(double x) {
    return x < 9.95     ? formatted("%.1f", x)
           : x < 999.5  ? formatted("%.0f", x)
           : x < 99950  ? formatted("%.1fk", x / 1e3)
           : x < 999500 ? formatted("%.0fk", x / 1e3)
                        : formatted("%.1fM", x / 1e6);
}

std::string short_time(double nanoseconds) {
    static constexpr const char* units[] = {" ns", " µs", " ms"};
    for (const char* unit : units) {
        if (nanoseconds < 999.5) {
            return formatted(nanoseconds < 9.995 ? "%.2f" : nanoseconds < 99.95 ? "%.1f" : "%.0f", nanoseconds) + unit;
        }
        nanoseconds /= 1e3;
    }
    return formatted(nanoseconds < 9.995 ? "%.2f" : nanoseconds < 99.95 ? "%.1f" : "%.0f", nanoseconds) + " s";
}

void text_table::column(std::string heading, bool left) {
    headings_.push_back(std::move(heading));
    left_.push_back(left);
}

void text_table::span(std::string heading, std::size_t first, std::size_t count) {
    spans_.push_back({std::move(heading), first, count});
}

void text_table::line(std::vector<std::string> cells) { lines_.push_back(std::move(cells)); }

void text_table::gap() { lines_.emplace_back(); }

std::string text_table::text() const {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < headings_.size(); ++i) {
        std::size_t width = width_of(headings_[i]);
        for (const auto& line : lines_) {
            width = std::max(width, i < line.size() ? width_of(line[i]) : 0);
        }
        widths.push_back(width);
    }
    const auto start_of = [&](std::size_t column) {
        std::size_t start = 0;
        for (std::size_t i = 0; i < column; ++i) {
            start += widths[i] + 2;
        }
        return start;
    };
    for (const heading_over& s : spans_) { // a heading that is too wide widens its first column
        const std::size_t have = start_of(s.first + s.count) - 2 - start_of(s.first);
        if (width_of(s.text) > have) {
            widths[s.first] += width_of(s.text) - have;
        }
    }
    std::string result;
    if (!spans_.empty()) {
        std::string over;
        for (const heading_over& s : spans_) {
            over = padded(over, start_of(s.first), true);
            const std::size_t room = start_of(s.first + s.count) - 2 - start_of(s.first);
            const std::size_t dashes = room - width_of(s.text);
            over += (dashes > 1 ? s.text + " " + std::string(dashes - 1, '-') : s.text) + "  ";
        }
        result += without_trailing_spaces(over) + "\n";
    }
    const auto add = [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t i = 0; i < headings_.size(); ++i) {
            line += padded(i < cells.size() ? cells[i] : "", widths[i], left_[i]) + "  ";
        }
        result += without_trailing_spaces(line) + "\n";
    };
    add(headings_);
    for (const auto& line : lines_) {
        add(line);
    }
    return result;
}

} // namespace compare
