// Text for a page: escaped names and readable numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace compare::report {

// The text with the markup characters of HTML and XML, quotes included, as entities. Control characters, and characters
// that change how others look, become question marks. Safe in element text and in quoted attributes.
[[nodiscard]] std::string escaped(std::string_view text);

// Three significant digits: "0", "0.32", "14.5", "1234", "3.1·10⁻¹⁷", "∞"; for a NaN "not a number".
[[nodiscard]] std::string readable(double value);

// The same, or a dash if there is no value.
[[nodiscard]] std::string readable(const std::optional<double>& value);

// "812 ps", "12.4 ns", "3.1 µs", "2.2 ms", with a space that does not break.
[[nodiscard]] std::string readable_time(double nanoseconds);

// With thin spaces: "12 345".
[[nodiscard]] std::string readable_count(unsigned long long count);

// "10⁻¹²", "2⁵³".
[[nodiscard]] std::string power_of_ten(int exponent);
[[nodiscard]] std::string power_of(int base, int exponent);

// "1 pair", "2 pairs".
[[nodiscard]] std::string counted(unsigned long long count, const std::string& one, const std::string& many);

} // namespace compare::report
