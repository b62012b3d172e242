// From an exact value to the nearest one of a binary floating format, in integers.
#pragma once

#include "exact_view.hpp"
#include "problem.hpp"

namespace compare {

// A whole number of any size.
using exact_integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

inline constexpr binary_format double_format{53, -1021, 1024};

enum class rounding { to_nearest, down, up }; // ties to even; down and up: towards minus and plus infinity

// (-1)^negative · significand · 2^exponent, or an infinity of that sign. The significand has at most `digits` bits.
struct rounded_value {
    bool negative = false;
    bool infinite = false;
    exact_integer significand = 0;
    long exponent = 0;
};

// x rounded once, to the format.
[[nodiscard]] rounded_value round_to(const exact& x, const binary_format& format,
                                     rounding direction = rounding::to_nearest);

// x rounded to nearest, ties to even, subnormals kept; ±infinity if x rounds to that. Zero is +0.
[[nodiscard]] double nearest_double(const exact& x);

// The largest double <= x and the smallest one >= x, infinities included.
[[nodiscard]] double double_below(const exact& x);
[[nodiscard]] double double_above(const exact& x);

// The exact value of a finite double. Throws std::domain_error for any other.
[[nodiscard]] exact exact_of(double x);

} // namespace compare
