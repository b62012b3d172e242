// From a formula to the constant of its filter, and from a computed value to a certain sign.
#pragma once

#include <graze/analysis/error_bound.hpp>

#include <bit>
#include <cstdint>

namespace graze::inline v0_1 {

// K such that |computed - exact| <= K Π scale_k^degree_k if F runs in doubles on inputs that `bounds`, the same inputs
// in error_bound, describes. It holds in every rounding mode, contracted or not. The slack also covers the roundings of
// the scales (fewer than 2^10) and of their products, provided that each scale is computed as a sum of non-negative
// terms.
template <class F, class B>
[[nodiscard]] consteval double filter_constant(F f, const B& bounds) {
    const auto bound = f(bounds);
    return bound.error * bound.unit * bound.slack;
}

template <class F, class B>
[[nodiscard]] consteval error_bound::degrees filter_degrees(F f, const B& bounds) {
    return f(bounds).degree;
}
// Whether these degrees are a, b and c. (The == of two arrays is not constant in the debug mode of libstdc++ 12.)
template <class F, class B>
[[nodiscard]] consteval bool has_degrees(F f, const B& bounds, int a, int b, int c) {
    const error_bound::degrees d = f(bounds).degree;
    return d[0] == a && d[1] == b && d[2] == c;
}

namespace detail {

// A filter's answer for a value: its sign if that is certain, otherwise `open`. A NaN is open.
inline constexpr int open = 2;

[[nodiscard]] constexpr int certain_sign(double value, double bound) noexcept {
    return value > bound ? 1 : value < -bound ? -1 : open;
}

// scale^Power, Power >= 0.
template <int Power, class S>
[[nodiscard]] constexpr S power_of(const S& scale) noexcept {
    if constexpr (Power == 0) {
        return S(1);
    } else if constexpr (Power == 1) {
        return scale;
    } else {
        const S half = power_of<Power / 2>(scale);
        return Power % 2 == 0 ? half * half : half * half * scale;
    }
}

// Whether x is a positive number in [2^Low, 2^High), by one comparison of its bits. False for zeros, negative numbers
// and NaNs, in any floating-point environment.
template <int Low, int High>
[[nodiscard]] constexpr bool bits_within_powers(std::uint64_t bits) noexcept {
    constexpr std::uint64_t low = static_cast<std::uint64_t>(1023 + Low) << 52;
    constexpr std::uint64_t high = static_cast<std::uint64_t>(1023 + High) << 52;
    return bits - low < high - low;
}
template <int Low, int High>
[[nodiscard]] constexpr bool within_powers(double x) noexcept {
    return bits_within_powers<Low, High>(std::bit_cast<std::uint64_t>(x));
}

} // namespace detail
} // namespace graze::inline v0_1
