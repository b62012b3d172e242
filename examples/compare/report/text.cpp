#include "text.hpp"

#include "../input_error.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace compare::report {
namespace {

[[nodiscard]] std::string fixed(double value, int decimals) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
    return buffer.data();
}

// Three significant digits of a value in [1e-3, 1e5).
[[nodiscard]] std::string plain(double value) {
    const double size = std::fabs(value);
    std::string text = fixed(value, size < 0.01 ? 4 : size < 0.1 ? 3 : size < 10 ? 2 : size < 100 ? 1 : 0);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text;
}

[[nodiscard]] std::string superscript(int number) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(number)) {
        text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    }
    return text;
}

} // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (const std::size_t formatting = formatting_at(text, at); formatting > 0) {
            safe += '?';
            at += formatting - 1;
            continue;
        }
        const char c = text[at];
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default: {
            const auto code = static_cast<unsigned char>(c);
            safe += (code < 0x20 && c != '\n' && c != '\t') || code == 0x7f ? '?' : c;
        }
        }
    }
    return safe;
}

std::string readable(double value) {
    if (std::isnan(value)) {
        return "not a number";
    }
    if (std::isinf(value)) {
        return value > 0 ? "∞" : "−∞";
    }
    const double size = std::fabs(value);
    if (size == 0) {
        return "0";
    }
    if (size >= 1e-3 && size < 1e5) {
        return plain(value);
    }
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.1e", value);
    const std::string text = buffer.data();
    const auto e = text.find('e');
    return text.substr(0, e) + "·10" + superscript(std::stoi(text.substr(e + 1)));
}

std::string readable(const std::optional<double>& value) { return value ? readable(*value) : "–"; }

std::string readable_time(double nanoseconds) {
    const double size = std::fabs(nanoseconds);
    if (size < 1) {
        return readable(nanoseconds * 1e3) + "\u00a0ps";
    }
    if (size < 1e3) {
        return readable(nanoseconds) + "\u00a0ns";
    }
    return size < 1e6 ? readable(nanoseconds / 1e3) + "\u00a0µs" : readable(nanoseconds / 1e6) + "\u00a0ms";
}

std::string readable_count(unsigned long long count) {
    std::string text = std::to_string(count);
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0 && count >= 10000; at -= 3) {
        text.insert(static_cast<std::size_t>(at), "\u2009");
    }
    return text;
}

std::string power_of_ten(int exponent) { return power_of(10, exponent); }

std::string power_of(int base, int exponent) { return std::to_string(base) + superscript(exponent); }

std::string counted(unsigned long long count, const std::string& one, const std::string& many) {
    return readable_count(count) + " " + (count == 1 ? one : many);
}

} // namespace compare::report
