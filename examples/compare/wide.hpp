// Binary floating-point numbers wide enough to hold exactly what the types compute, and the truth to 2^-890.
#pragma once

#include "problem.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdint>
#include <limits>
#include <optional>

namespace compare {

inline constexpr int wide_digits = 896;
using wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<wide_digits, boost::multiprecision::digit_base_2, void, std::int64_t>,
    boost::multiprecision::et_off>;

// The nearest wide number. The relative error is below 2^-892; it is 0 if x's denominator is a power of two and its
// numerator has at most wide_digits bits.
[[nodiscard]] wide to_wide(const exact& x);

// Whether to_wide(x) is x.
[[nodiscard]] bool is_wide(const exact& x);

// The value of a finite double or long double, exactly.
[[nodiscard]] wide wide_of(double x);
[[nodiscard]] wide wide_of(long double x);

// floor(log2|x|) for x != 0.
[[nodiscard]] long exponent_of(const wide& x);

// x · 2^exponent as a double; 0 only where x is, infinity beyond the range.
[[nodiscard]] double scaled(const wide& x, long exponent);

// x rounded to nearest, ties to even, subnormals kept, infinite beyond the range.
[[nodiscard]] double nearest_double(const wide& x);

// The middle of two adjacent doubles that x is within |x| 2^-800 of, if there is one.
[[nodiscard]] std::optional<wide> middle_beside(const wide& x);

// The exact value.
[[nodiscard]] exact to_exact(const wide& x);

} // namespace compare
