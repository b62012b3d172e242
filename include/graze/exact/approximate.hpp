// Wide integers as doubles with a separate exponent.
#pragma once

#include <graze/exact/big_integer.hpp>
#include <graze/exact/integer.hpp>

#include <bit>
#include <cstdint>

namespace graze::inline v0_1::detail {

// significand · 2^exponent, within a relative 4u of an integer in any rounding mode; 0 is exact. The significand is
// below 2^65 in magnitude, so neither it nor its square can over- or underflow.
struct scaled_double {
    double significand = 0;
    int exponent = 0;
};

// 2^power; power in [-1022, 1023].
[[nodiscard]] constexpr double power_of_two(int power) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52);
}

template <int Bits>
[[nodiscard]] constexpr scaled_double approximate(const integer<Bits>& x) noexcept {
    const integer<Bits> magnitude = x.is_negative() ? -x : x;
    int top = integer<Bits>::limbs - 1;
    while (top > 0 && magnitude.limb(top) == 0) {
        --top;
    }
    // The top limb and the 64 bits after it, normalised: at least 64 significant bits.
    const int zeros = std::countl_zero(magnitude.limb(top));
    const std::uint64_t below = top > 0 ? magnitude.limb(top - 1) : 0;
    const std::uint64_t word =
        zeros == 0 || zeros == 64 ? magnitude.limb(top) : magnitude.limb(top) << zeros | below >> (64 - zeros);
    const double value = static_cast<double>(static_cast<std::int64_t>(word >> 1)) * 2.0;
    return {x.is_negative() ? -value : value, 64 * top - (zeros == 64 ? 0 : zeros)};
}

// If the highest digit is small, the next one carries the significant bits. All digits below are less than one part in
// 2^63 of these two.
[[nodiscard, gnu::noinline]] constexpr scaled_double approximate(const big_integer& x) noexcept {
    if (x.count() == 0) {
        return {};
    }
    const int last = x.count() - 1;
    const double high =
        static_cast<double>(x.digit(last)) + (last > 0 ? static_cast<double>(x.digit(last - 1)) * 0x1p-64 : 0.0);
    return {x.is_negated() ? -high : high, 64 * (x.low() + last)};
}

} // namespace graze::inline v0_1::detail
