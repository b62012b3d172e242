// Finite binary numbers taken apart: significand · 2^exponent, from their bits alone.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace graze {

// The types of whose values the predicates take decisions: float, double, and signed integers of 32 and of 64 bits
// under whichever name.
template <class T>
inline constexpr bool is_binary_input = std::same_as<T, float> || std::same_as<T, double> ||
                                        (std::signed_integral<T> && (sizeof(T) == 4 || sizeof(T) == 8));

} // namespace graze

namespace graze::detail {

// significand · 2^exponent. The significand is odd or 0 (then the exponent means nothing).
struct binary {
    std::int64_t significand = 0;
    int exponent = 0;
};

// The bits of x, read through the reference, so that no arithmetic register quietens or flushes the value.
[[nodiscard]] constexpr std::uint64_t bits_of(const double& x) noexcept { return std::bit_cast<std::uint64_t>(x); }
[[nodiscard]] constexpr std::uint32_t bits_of(const float& x) noexcept { return std::bit_cast<std::uint32_t>(x); }

[[nodiscard]] constexpr binary odd(std::int64_t significand, int exponent) noexcept {
    if (significand == 0) {
        return {0, 0};
    }
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(significand));
    return {significand >> zeros, exponent + zeros};
}

// Whether x is neither infinite nor NaN, by its exponent bits.
[[nodiscard]] constexpr bool is_finite_input(const double& x) noexcept {
    return (bits_of(x) & 0x7ff0000000000000U) != 0x7ff0000000000000U;
}
[[nodiscard]] constexpr bool is_finite_input(const float& x) noexcept {
    return (bits_of(x) & 0x7f800000U) != 0x7f800000U;
}
template <std::signed_integral T>
[[nodiscard]] constexpr bool is_finite_input(const T&) noexcept {
    return true;
}

// Whether T is an integer that a double may not hold.
template <class T>
inline constexpr bool is_wide_integer = std::signed_integral<T> && sizeof(T) == 8;

// Whether x is so small that a mode may read it as 0.
[[nodiscard]] constexpr bool is_subnormal(const double& x) noexcept {
    return (bits_of(x) & 0x7ff0000000000000U) == 0 && bits_of(x) << 1 != 0;
}
[[nodiscard]] constexpr bool is_subnormal(const float& x) noexcept {
    return (bits_of(x) & 0x7f800000U) == 0 && bits_of(x) << 1 != 0;
}

// x as significand · 2^exponent with the significand as it is stored.
[[nodiscard]] constexpr binary split(const double& x) noexcept {
    const std::uint64_t bits = bits_of(x);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t hidden = field != 0 ? std::uint64_t{1} << 52 : 0;
    const auto magnitude = static_cast<std::int64_t>((bits & 0xfffffffffffffU) | hidden);
    return {bits >> 63 != 0 ? -magnitude : magnitude, (field != 0 ? field : 1) - 1075};
}
[[nodiscard]] constexpr binary split(const float& x) noexcept {
    const std::uint32_t bits = bits_of(x);
    const int field = static_cast<int>(bits >> 23 & 0xff);
    const std::uint32_t hidden = field != 0 ? std::uint32_t{1} << 23 : 0;
    const auto magnitude = static_cast<std::int64_t>((bits & 0x7fffffU) | hidden);
    return {bits >> 31 != 0 ? -magnitude : magnitude, (field != 0 ? field : 1) - 150};
}
template <std::signed_integral T>
[[nodiscard]] constexpr binary split(const T& x) noexcept {
    return {x, 0};
}

// |significand| < 2^stored_bits as split gives it.
template <class T>
inline constexpr int stored_bits = std::numeric_limits<T>::is_integer ? 8 * static_cast<int>(sizeof(T))
                                                                      : std::numeric_limits<T>::digits;

// x taken apart; x is finite. Exact for subnormals, whatever the flushing mode.
template <class T>
requires is_binary_input<T>
[[nodiscard]] constexpr binary to_binary(const T& x) noexcept {
    const binary b = split(x);
    return odd(b.significand, b.exponent);
}

// K numbers as integers on one scale: value_i = significand_i · 2^(shift_i + exponent), 0 <= shift_i, |value_i| <
// 2^(width + exponent).
template <std::size_t K>
struct lifted {
    std::array<std::int64_t, K> significand{};
    std::array<int, K> shift{};
    int exponent = 0;
    int width = 0;

    // Value i over 2^exponent, in an integer type of at least `width` bits.
    template <class I>
    [[nodiscard]] constexpr I get(std::size_t i) const noexcept {
        return I::from_shifted(significand[i], shift[i]);
    }
};

// K numbers from `values` on, lifted. Zeros take no part in the scale; bits that are zero in all significands are left
// out, so that small integers and numbers on a grid stay narrow.
template <std::size_t K, class T>
constexpr void lift(lifted<K>& r, const T* values) noexcept {
    int low = std::numeric_limits<int>::max();
    int high = std::numeric_limits<int>::min();
    std::uint64_t any = 0;
    for (std::size_t i = 0; i < K; ++i) {
        const binary b = split(values[i]);
        r.significand[i] = b.significand;
        r.shift[i] = b.exponent;
        any |= static_cast<std::uint64_t>(b.significand);
        low = b.significand != 0 && b.exponent < low ? b.exponent : low;
        high = b.significand != 0 && b.exponent > high ? b.exponent : high;
    }
    if (any == 0) {
        r.shift = {};
        return;
    }
    const int zeros = std::countr_zero(any);
    r.exponent = low + zeros;
    r.width = high - low + stored_bits<T> - zeros;
    for (std::size_t i = 0; i < K; ++i) {
        r.shift[i] = r.significand[i] != 0 ? r.shift[i] - low : 0;
        r.significand[i] >>= zeros;
    }
}

// Brings two groups to their common scale and width.
template <std::size_t K, std::size_t L>
constexpr void align(lifted<K>& x, lifted<L>& y) noexcept {
    const int exponent = x.exponent < y.exponent ? x.exponent : y.exponent;
    const auto rescale = [exponent](auto& group) {
        const int up = group.exponent - exponent;
        for (std::size_t i = 0; i < group.shift.size(); ++i) {
            group.shift[i] += group.significand[i] != 0 ? up : 0;
        }
        group.exponent = exponent;
        group.width += up;
    };
    rescale(x);
    rescale(y);
    x.width = y.width = x.width > y.width ? x.width : y.width;
}

} // namespace graze::detail
