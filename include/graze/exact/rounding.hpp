// From a truncated magnitude to a float or a double, by its bits.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace graze::inline v0_1 {

// nearest: ties to even; infinite from the middle between the largest number and the next power of two on. downward,
// upward: the nearest number that is not above, or not below; beyond the largest number that is the largest number or
// an infinity.
enum class rounding { nearest, downward, upward };

namespace detail {

// A binary format: its significand's bits, and the exponents of the lowest bits of its smallest and largest numbers.
struct binary_format {
    int precision;
    int lowest;
    int highest;

    // The bits of +∞. Numbers of smaller magnitude have smaller bits.
    [[nodiscard]] constexpr std::uint64_t infinite_bits() const noexcept {
        return static_cast<std::uint64_t>(highest - lowest + 2) << (precision - 1);
    }
    // The bits of m · 2^exponent, lowest <= exponent, where m < 2^precision, and m >= 2^(precision - 1) unless the
    // exponent is the lowest one. The hidden bit adds one to the exponent field; so does m = 2^precision, a carry.
    [[nodiscard]] constexpr std::uint64_t pack(std::uint64_t m, int exponent) const noexcept {
        return (static_cast<std::uint64_t>(exponent - lowest) << (precision - 1)) + m;
    }
};

template <class T>
inline constexpr binary_format format_of = {std::numeric_limits<T>::digits,
                                            std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits,
                                            std::numeric_limits<T>::max_exponent - std::numeric_limits<T>::digits};

// A magnitude truncated one bit below the last place of a format: halves · 2^exponent, and whether there is more.
struct cut_off {
    std::uint64_t halves;
    int exponent;
    bool more;
};

// The bits of ±x rounded. Adding one to the bits leads to the next number, even across powers of two, from subnormal to
// normal numbers, and from the largest number to infinity.
[[nodiscard]] constexpr std::uint64_t rounded_bits(const binary_format& format, const cut_off& x, bool negative,
                                                   rounding mode) noexcept {
    const std::uint64_t infinity = format.infinite_bits();
    const bool away = mode == (negative ? rounding::downward : rounding::upward);
    std::uint64_t bits = infinity;
    if (x.exponent + 1 <= format.highest) {
        bits = format.pack(x.halves >> 1, x.exponent + 1);
        const bool half = (x.halves & 1) != 0;
        const bool up = mode == rounding::nearest ? half && (x.more || (bits & 1) != 0) : away && (half || x.more);
        bits += up ? 1U : 0U;
    }
    if (bits >= infinity) {
        bits = mode == rounding::nearest || away ? infinity : infinity - 1;
    }
    return bits;
}

// The number with these bits and this sign.
template <class T>
[[nodiscard]] constexpr T from_bits(std::uint64_t bits, bool negative) noexcept {
    if constexpr (sizeof(T) == sizeof(std::uint32_t)) {
        return std::bit_cast<T>(static_cast<std::uint32_t>(bits | static_cast<std::uint64_t>(negative) << 31));
    } else {
        return std::bit_cast<T>(bits | static_cast<std::uint64_t>(negative) << 63);
    }
}

} // namespace detail
} // namespace graze::inline v0_1
