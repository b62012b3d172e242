// Exact binary numbers, from which inputs of any type are made without floating-point arithmetic.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

namespace environments {

// significand · 2^exponent.
struct number {
    std::int64_t significand = 0;
    int exponent = 0;
};

[[nodiscard]] constexpr std::uint64_t magnitude_of(std::int64_t x) {
    return x < 0 ? -static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
}

// The exponent of the bit above the highest one of x, which is not 0.
[[nodiscard]] constexpr int top_of(const number& x) {
    return x.exponent + static_cast<int>(std::bit_width(magnitude_of(x.significand)));
}

[[nodiscard]] constexpr number number_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = (bits & 0xfffffffffffffU) | (field != 0 ? std::uint64_t{1} << 52 : 0);
    const auto significand = static_cast<std::int64_t>(fraction);
    return {bits >> 63 != 0 ? -significand : significand, (field != 0 ? field : 1) - 1075};
}

// |x| / 2^exponent, cut to an integer.
[[nodiscard]] constexpr std::uint64_t cut(const number& x, int exponent) {
    const int shift = x.exponent - exponent;
    return shift >= 0 ? magnitude_of(x.significand) << shift : shift > -64 ? magnitude_of(x.significand) >> -shift : 0;
}

// x as a T, cut towards zero; nothing if it is too large.
template <std::floating_point T>
[[nodiscard]] constexpr std::optional<T> as(const number& x) {
    using limits = std::numeric_limits<T>;
    using word = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr int fraction_bits = limits::digits - 1;
    constexpr int lowest = limits::min_exponent - limits::digits; // of the smallest subnormal
    if (x.significand == 0) {
        return T(0);
    }
    if (top_of(x) > limits::max_exponent) {
        return std::nullopt;
    }
    const int exponent = top_of(x) - limits::digits < lowest ? lowest : top_of(x) - limits::digits;
    const std::uint64_t fraction = cut(x, exponent);
    const auto sign = static_cast<word>(word{x.significand < 0} << (8 * sizeof(T) - 1));
    const bool normal = fraction >> fraction_bits != 0;
    const auto field = static_cast<word>(normal ? exponent - lowest + 1 : 0);
    constexpr word mask = (word{1} << fraction_bits) - 1;
    return std::bit_cast<T>(
        static_cast<word>(sign | static_cast<word>(field << fraction_bits) | (static_cast<word>(fraction) & mask)));
}

template <std::signed_integral T>
[[nodiscard]] constexpr std::optional<T> as(const number& x) {
    if (x.significand == 0) {
        return T(0);
    }
    if (top_of(x) > std::numeric_limits<T>::digits) {
        return std::nullopt;
    }
    const auto magnitude = static_cast<T>(cut(x, 0));
    return x.significand < 0 ? static_cast<T>(-magnitude) : magnitude;
}

static_assert(as<double>(number_of(0x1.8p-1070)) == 0x1.8p-1070 && as<double>(number_of(-0x1.2p1023)) == -0x1.2p1023);
static_assert(as<float>({-3, -149}) == -0x3p-149F && as<float>({0x1ffffff, 0}) == 0x1.fffffep24F);
static_assert(!as<float>({1, 128}) && as<float>({1, -200}) == 0.0F && as<std::int32_t>({-7, -1}) == -3);

} // namespace environments
