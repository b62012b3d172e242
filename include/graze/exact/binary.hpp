// Finite binary numbers as significand · 2^exponent, from their bits alone.
#pragma once

#include <graze/exact/big_integer.hpp>
#include <graze/machine/fence.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace graze::inline v0_1 {

// The types that decisions accept: float, double, and signed integers of 32 and 64 bits under any name.
template <class T>
inline constexpr bool is_binary_input = std::same_as<T, float> || std::same_as<T, double> ||
                                        (std::signed_integral<T> && (sizeof(T) == 4 || sizeof(T) == 8));

} // namespace graze::inline v0_1

namespace graze::inline v0_1::detail {

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

// Whether x is neither infinite nor NaN, judged by its exponent bits.
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

// Whether T is an integer type with values that no double equals.
template <class T>
inline constexpr bool is_wide_integer = std::signed_integral<T> && sizeof(T) == 8;

// Whether x is so small that a mode may read it as 0. The bits are tested for a range: a test of all bits but the sign
// for 0 becomes a comparison of x with 0 in clang, and the mode would then read x as 0.
[[nodiscard]] constexpr bool is_subnormal(const double& x) noexcept {
    return (bits_of(x) << 1 >> 1) - 1 < 0xfffffffffffffU;
}
[[nodiscard]] constexpr bool is_subnormal(const float& x) noexcept { return (bits_of(x) << 1 >> 1) - 1 < 0x7fffffU; }

// x as significand · 2^exponent, with the significand as stored.
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

// A finite x as significand · 2^exponent. Exact for subnormals, whatever the flushing mode.
template <class T>
requires is_binary_input<T>
[[nodiscard]] constexpr binary to_binary(const T& x) noexcept {
    const binary b = split(x);
    return odd(b.significand, b.exponent);
}

// An unsigned number that is ordered like |x|. Its lowest bits are the significand's, without the hidden bit.
[[nodiscard]] constexpr std::uint64_t order_of_magnitude(const double& x) noexcept { return bits_of(x) << 1 >> 1; }
[[nodiscard]] constexpr std::uint64_t order_of_magnitude(const float& x) noexcept { return bits_of(x) << 1 >> 1; }
template <std::signed_integral T>
[[nodiscard]] constexpr std::uint64_t order_of_magnitude(const T& x) noexcept {
    const auto bits = static_cast<std::uint64_t>(std::int64_t{x});
    return x < 0 ? 0 - bits : bits;
}

// Whether x is 0 of either sign. The bits are opaque to the compiler: where it handles two at a time, clang 19 would
// otherwise compare the numbers, and a subnormal equals 0 if a mode reads it as 0.
template <class T>
requires is_binary_input<T>
[[nodiscard]] constexpr bool is_zero(const T& x) noexcept { return opaque(order_of_magnitude(x)) == 0; }

// For a number with this order_of_magnitude: its exponent by split, and the largest width of its stored significand.
template <class T>
[[nodiscard]] constexpr int stored_exponent(std::uint64_t order) noexcept {
    if constexpr (std::signed_integral<T>) {
        return 0;
    } else {
        constexpr int digits = std::numeric_limits<T>::digits;
        const int field = static_cast<int>(order >> (digits - 1));
        return (field != 0 ? field : 1) - (std::numeric_limits<T>::max_exponent + digits - 2);
    }
}
template <class T>
[[nodiscard]] constexpr int stored_bits(std::uint64_t highest_order) noexcept {
    return std::signed_integral<T> ? static_cast<int>(std::bit_width(highest_order)) : std::numeric_limits<T>::digits;
}

// K numbers as integers on a common scale: value_i = get(i) · 2^exponent, |get(i)| < 2^width. Zeros do not affect the
// scale. Low bits that are zero in all significands are dropped, so that small integers and numbers on a grid stay
// narrow.
template <std::size_t K>
struct lifted {
    std::array<std::int64_t, K> significand; // not zeroed first, since lift writes all of them
    std::array<int, K> power;
    int lowest = 0; // the exponent of a significand with shift 0
    int zeros = 0;  // trailing zeros that all significands share
    int exponent = 0;
    int width = 0;
    workspace* room = nullptr; // for the digits of big integers

    // Value i divided by 2^exponent, in an integer type of at least `width` bits or of any size.
    template <class I>
    [[nodiscard]] constexpr I get(std::size_t i) const noexcept {
        const int shift = significand[i] != 0 ? power[i] - lowest : 0;
        if constexpr (std::same_as<I, big_integer>) {
            return I::from_shifted(*room, significand[i] >> zeros, shift);
        } else {
            return I::from_shifted(significand[i] >> zeros, shift);
        }
    }

    // Value i plus or minus value j, likewise. Big integers of one limb are added there.
    template <class I>
    [[nodiscard, gnu::noinline]] constexpr auto sum(std::size_t i, std::size_t j, bool subtract) const noexcept {
        if constexpr (std::same_as<I, big_integer>) {
            if (width <= 61) {
                const std::int64_t x = short_value(i);
                const std::int64_t y = short_value(j);
                return I::from_shifted(*room, subtract ? x - y : x + y, 0);
            }
            return I::sum(get<I>(i), get<I>(j), subtract);
        } else {
            return subtract ? get<I>(i) - get<I>(j) : get<I>(i) + get<I>(j);
        }
    }

    // The exponent of the largest power of two of which all values are multiples; it is not below `exponent`, which is
    // cheaper.
    [[nodiscard]] constexpr int unit() const noexcept {
        int least = width != 0 ? exponent + width : exponent;
        for (std::size_t i = 0; i < K; ++i) {
            if (const binary x = odd(significand[i], power[i]); x.significand != 0 && x.exponent < least) {
                least = x.exponent;
            }
        }
        return least;
    }

  private:
    [[nodiscard]] constexpr std::int64_t short_value(std::size_t i) const noexcept {
        return significand[i] != 0 ? (significand[i] >> zeros) * (std::int64_t{1} << (power[i] - lowest)) : 0;
    }
};

// Lifts K finite numbers, from `values` on.
template <std::size_t K, class T>
constexpr void lift(lifted<K>& r, const T* values) noexcept {
    std::uint64_t high = 0;
    std::uint64_t low = ~std::uint64_t{0}; // the least order less one: a 0 wraps to the highest
    std::uint64_t any = 0;
    for (std::size_t i = 0; i < K; ++i) {
        const std::uint64_t order = order_of_magnitude(values[i]);
        const binary x = split(values[i]);
        r.significand[i] = x.significand;
        r.power[i] = x.exponent;
        any |= order;
        high = order > high ? order : high;
        low = order - 1 < low ? order - 1 : low;
    }
    if (opaque(any) == 0) { // opaque as in is_zero
        return;
    }
    if constexpr (!std::signed_integral<T>) {
        any |= std::uint64_t{1} << (std::numeric_limits<T>::digits - 1); // the only possible hidden bit
    }
    r.zeros = std::countr_zero(any);
    r.lowest = stored_exponent<T>(low + 1);
    r.exponent = r.lowest + r.zeros;
    r.width = stored_exponent<T>(high) - r.lowest + stored_bits<T>(high) - r.zeros;
}

// Brings a group to another scale, which must not be above its own.
template <std::size_t K>
constexpr void lower(lifted<K>& x, int exponent) noexcept {
    const int down = x.exponent - exponent;
    x.lowest -= down;
    x.exponent = exponent;
    x.width += down;
}

// Brings two groups to their common scale and width.
template <std::size_t K, std::size_t L>
constexpr void align(lifted<K>& x, lifted<L>& y) noexcept {
    const int exponent = x.exponent < y.exponent ? x.exponent : y.exponent;
    lower(x, exponent);
    lower(y, exponent);
    x.width = y.width = x.width > y.width ? x.width : y.width;
}

} // namespace graze::inline v0_1::detail
