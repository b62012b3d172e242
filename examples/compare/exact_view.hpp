// Exact numbers as a number type's translation unit sees them: without the library that holds them, whose headers take
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

// Its digits to the base 2^32, the highest first.
struct whole_number {
    bool negative = false;
    std::vector<std::uint32_t> digits;
};

// significand · 2^exponent, or an infinity of that sign.
struct binary_number {
    whole_number significand;
    long exponent = 0;
    bool infinite = false;
};

struct fraction {
    whole_number numerator, denominator;
};

// An exact rational that lives elsewhere.
class exact_view {
  public:
    [[nodiscard]] bool is_zero() const;
    [[nodiscard]] fraction parts() const;                   // in lowest terms, the denominator above 0
    [[nodiscard]] std::string numerator_in_decimal() const; // and the denominator's
    [[nodiscard]] std::string denominator_in_decimal() const;
    // Rounded once, to nearest, ties to even; the inverse is not of 0.
    [[nodiscard]] binary_number rounded(const binary_format& format) const;
    [[nodiscard]] binary_number inverse_rounded(const binary_format& format) const;
    [[nodiscard]] double nearest() const;
    [[nodiscard]] double nearest_to_rest(double taken) const; // of the number less a finite double
    [[nodiscard]] double below() const;                       // the largest double that is not above
    [[nodiscard]] double above() const;                       // the smallest one that is not below
    // The nearest whole number to its product with 2^bits, ties away from zero.
    [[nodiscard]] whole_number in_units(unsigned bits) const;

  private:
    friend struct exact_access; // knows what is behind it
    explicit exact_view(const void* value) : value_(value) {}
    const void* value_;
};

} // namespace compare
