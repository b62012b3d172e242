// The built-in floating-point types as numbers: float, double, long double.
#pragma once

#include <graze/number/traits.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace graze::inline v0_1 {

namespace detail {

// The correctly rounded square root of a double in a constant expression, where clang has no std::sqrt. It computes 54
// bits of the root, digit by digit, and a remainder. There are no ties: the root of a 53-bit number is never halfway
// between two 53-bit numbers.
[[nodiscard]] constexpr double constant_sqrt(double x) {
    if (!(x > 0.0) || x > std::numeric_limits<double>::max()) {
        return x < 0.0 ? std::numeric_limits<double>::quiet_NaN() : x;
    }
    std::uint64_t significand = std::bit_cast<std::uint64_t>(x);
    int exponent = static_cast<int>(significand >> 52);
    significand &= (std::uint64_t{1} << 52) - 1;
    if (exponent == 0) {
        exponent = 1;
        while ((significand >> 52) == 0) {
            significand <<= 1;
            --exponent;
        }
    } else {
        significand |= std::uint64_t{1} << 52;
    }
    exponent -= 1075; // x = significand 2^exponent
    if (exponent % 2 != 0) {
        significand <<= 1;
        --exponent;
    }
    // The root of significand 2^(2k) has 54 bits for k = 27 when significand has 53 or 54 bits.
    std::uint64_t root = 0;
    std::uint64_t remainder = 0;
    for (int pair = 26; pair >= -27; --pair) {
        const std::uint64_t next = pair >= 0 ? (significand >> (2 * pair)) & 3 : 0;
        remainder = remainder << 2 | next;
        const std::uint64_t trial = root << 2 | 1;
        root <<= 1;
        if (remainder >= trial) {
            remainder -= trial;
            root |= 1;
        }
    }
    const std::uint64_t rounded = (root >> 1) + (root & 1); // 53 bits; may carry to 2^53, which is exact too
    double result = static_cast<double>(rounded);
    for (int power = exponent / 2 - 26; power != 0; power += power < 0 ? 1 : -1) {
        result *= power < 0 ? 0.5 : 2.0;
    }
    return result;
}

} // namespace detail

template <>
struct number_traits<float> {
    static constexpr const char* name = "float";
    static constexpr bool is_exact = false;
    static constexpr int digits = std::numeric_limits<float>::digits;
    // Innocuous double rounding: a float's root, taken in double and then rounded to float, is as if rounded once (53
    // >= 2*24 + 2).
    static constexpr float sqrt(float x) noexcept {
        return std::is_constant_evaluated() ? static_cast<float>(detail::constant_sqrt(static_cast<double>(x)))
                                            : std::sqrt(x);
    }
    static float fma(float x, float y, float z) noexcept { return std::fma(x, y, z); }
};

template <>
struct number_traits<double> {
    static constexpr const char* name = "double";
    static constexpr bool is_exact = false;
    static constexpr int digits = std::numeric_limits<double>::digits;
    static constexpr double sqrt(double x) noexcept {
        return std::is_constant_evaluated() ? detail::constant_sqrt(x) : std::sqrt(x);
    }
    static double fma(double x, double y, double z) noexcept { return std::fma(x, y, z); }
};

template <>
struct number_traits<long double> {
    static constexpr const char* name = "long double";
    static constexpr bool is_exact = false;
    static constexpr int digits = std::numeric_limits<long double>::digits;
    static long double sqrt(long double x) noexcept { return std::sqrt(x); }
    static long double fma(long double x, long double y, long double z) noexcept { return std::fma(x, y, z); }
};

} // namespace graze::inline v0_1
