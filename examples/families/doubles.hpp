// Doubles assembled from integers, without a floating-point operation: no compiler flag, rounding mode or flush-to-zero
// changes them.
#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>

namespace families {

// significand · 2^exponent. Throws std::logic_error if no finite double, normal or subnormal, has that value.
[[nodiscard]] constexpr double make_double(std::int64_t significand, int exponent) {
    if (significand == 0) {
        return 0.0;
    }
    const std::uint64_t sign = significand < 0 ? std::uint64_t{1} << 63U : 0;
    std::uint64_t magnitude = static_cast<std::uint64_t>(significand < 0 ? -significand : significand);
    exponent += std::countr_zero(magnitude);
    magnitude >>= static_cast<unsigned>(std::countr_zero(magnitude));
    const int width = static_cast<int>(std::bit_width(magnitude));
    const int top = exponent + width - 1;
    if (width > 53 || exponent < -1074 || top > 1023) {
        throw std::logic_error("make_double: not a double");
    }
    if (top < -1022) {
        return std::bit_cast<double>(sign | magnitude << static_cast<unsigned>(exponent + 1074));
    }
    const std::uint64_t fraction = magnitude << static_cast<unsigned>(53 - width) & 0xfffffffffffffU;
    return std::bit_cast<double>(sign | static_cast<std::uint64_t>(top + 1023) << 52U | fraction);
}

// The neighbour of a finite x that is one unit in the last place larger (steps = 1) or smaller (-1) in magnitude. 0 has
// no smaller neighbour and stays.
[[nodiscard]] constexpr double beside(double x, int steps) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    if (bits << 1U == 0 && steps < 0) {
        return x;
    }
    return std::bit_cast<double>(steps < 0 ? bits - 1 : bits + 1);
}

// x · 2^exponent for zero and for a normal x whose result is normal; std::logic_error otherwise.
[[nodiscard]] constexpr double times_power_of_two(double x, int exponent) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    if (bits << 1U == 0) {
        return x;
    }
    const int field = static_cast<int>(bits >> 52U & 0x7ffU);
    const int scaled = field + exponent;
    if (field == 0 || field == 0x7ff || scaled < 1 || scaled > 0x7fe) {
        throw std::logic_error("times_power_of_two: out of range");
    }
    return std::bit_cast<double>((bits & ~(std::uint64_t{0x7ff} << 52U)) | static_cast<std::uint64_t>(scaled) << 52U);
}

// -x, by its bits.
[[nodiscard]] constexpr double negated(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ std::uint64_t{1} << 63U);
}

} // namespace families
