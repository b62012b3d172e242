// Exact numbers as a number type's translation unit sees them: without the library that holds them, since that takes
// longer to compile than the formulas in the type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace compare {

// In the convention of std::numeric_limits: finite values are below 2^max_exponent, the smallest normal one is
// 2^(min_exponent - 1), and the subnormal ones below it are multiples of 2^(min_exponent - digits).
struct binary_format {
    long digits;
    long min_exponent;
    long max_exponent;
};

// digits: to the base 2^32, the highest first.
struct whole_number {
    bool negative = false;
    std::vector<std::uint32_t> digits;
};

// significand · 2^exponent, or an infinity with the significand's sign.
struct binary_number {
    whole_number significand;
    long exponent = 0;
    bool infinite = false;
};

struct fraction {
    whole_number numerator, denominator;
};

// A non-owning view of an exact rational.
class exact_view {
  public:
    [[nodiscard]] bool is_zero() const;
    [[nodiscard]] fraction parts() const;                   // in lowest terms, the denominator positive
    [[nodiscard]] std::string numerator_in_decimal() const; // in lowest terms
    [[nodiscard]] std::string denominator_in_decimal() const;
    // Rounded once, to nearest, ties to even. The inverse of 0 must not be asked for.
    [[nodiscard]] binary_number rounded(const binary_format& format) const;
    [[nodiscard]] binary_number inverse_rounded(const binary_format& format) const;
    [[nodiscard]] double nearest() const;
    [[nodiscard]] double nearest_to_rest(double taken) const; // the number less `taken`, a finite double, rounded
    [[nodiscard]] double below() const;                       // the largest double that is not above the number
    [[nodiscard]] double above() const;                       // the smallest double that is not below the number
    // The number times 2^bits, rounded to the nearest whole number, ties away from zero.
    [[nodiscard]] whole_number in_units(unsigned bits) const;

  private:
    friend struct exact_access; // knows the type behind value_
    explicit exact_view(const void* value) : value_(value) {}
    const void* value_;
};

} // namespace compare
