// The leading 64 bits of a real number with a running error, in integer arithmetic alone. So results are the same in
// every floating-point environment and in constant expressions.
#pragma once

#include <graze/exact/big_integer.hpp>
#include <graze/exact/integer.hpp>
#include <graze/machine/wide_divide.hpp>

#include <bit>
#include <cstdint>

namespace graze::inline v0_1::detail {

// |x - (±significand) 2^exponent| <= error 2^exponent. The significand is at least 2^63, or 0. If it is 0, then x is 0
// if the error is 0, and unknown otherwise. The bounds below hold for errors up to 2^40, far above what callers accept.
struct leading {
    std::uint64_t significand = 0;
    std::uint64_t error = 0;
    int exponent = 0;
    bool negative = false;

    // Whether the error is at most `limit`. True for an exact 0.
    [[nodiscard]] constexpr bool is_within(std::uint64_t limit) const noexcept {
        return error <= limit && (significand != 0 || error == 0);
    }
};

inline constexpr std::uint64_t no_bits = ~std::uint64_t{0}; // the error of an unknown number

// The first 64 bits, truncated, of high · 2^64 + low, in units of 2^exponent; the number is not 0.
[[nodiscard]] constexpr leading leading_of_words(std::uint64_t high, std::uint64_t low, int exponent, bool negative,
                                                 std::uint64_t error) noexcept {
    if (high == 0) {
        const int zeros = std::countl_zero(low);
        return {low << zeros, error << zeros, exponent - zeros, negative};
    }
    const int zeros = std::countl_zero(high);
    const std::uint64_t below = zeros == 0 ? 0 : low >> (64 - zeros);
    return {high << zeros | below, 1 + (error >> (64 - zeros - 1) >> 1), exponent + 64 - zeros, negative};
}

// For a negative x, |x| is one more than its complement.
template <int Bits>
[[nodiscard, gnu::noinline]] constexpr leading leading_of(const integer<Bits>& x) noexcept {
    const bool negative = x.is_negative();
    const std::uint64_t flip = negative ? ~std::uint64_t{0} : 0;
    int top = integer<Bits>::limbs - 1;
    while (top > 0 && x.limb(top) == flip) {
        --top;
    }
    if (top > 0) {
        return leading_of_words(x.limb(top) ^ flip, x.limb(top - 1) ^ flip, 64 * (top - 1), negative, negative ? 1 : 0);
    }
    const std::uint64_t magnitude = (x.limb(0) ^ flip) - flip;
    return magnitude != 0 ? leading_of_words(0, magnitude, 0, negative, 0)
           : negative     ? leading{std::uint64_t{1} << 63, 0, 1, true}
                          : leading{};
}

// Three digits are needed for 64 bits: the highest may be ±1 with a next digit of the other sign. All digits below the
// three amount to less than one unit of the third.
[[nodiscard, gnu::noinline]] constexpr leading leading_of(const big_integer& x) noexcept {
    const int top = x.count() - 1;
    if (top < 0) {
        return {};
    }
    std::uint64_t digit[3] = {static_cast<std::uint64_t>(x.digit(top)), 0, 0}; // two's complement, highest first
    for (int place = 1; place <= 2 && place <= top; ++place) {
        const std::int64_t value = x.digit(top - place);
        digit[place] = static_cast<std::uint64_t>(value);
        for (int above = place - 1; value < 0 && above >= 0 && digit[above]-- == 0; --above) {
        }
    }
    if (x.digit(top) < 0) {
        std::uint64_t carry = 1;
        for (int i = 2; i >= 0; --i) {
            digit[i] = add_with_carry(~digit[i], 0, carry);
        }
    }
    const int position = x.low() + top;
    const bool negative = x.sign() < 0;
    const std::uint64_t error = top > 2 ? 1 : 0;
    return digit[0] != 0 ? leading_of_words(digit[0], digit[1], 64 * (position - 1), negative, 1)
                         : leading_of_words(digit[1], digit[2], 64 * (position - 2), negative, error);
}

// s₁s₂ is off by at most 2^64 (e₁ + e₂) + e₁e₂, which is less than e₁ + e₂ + 1 units of its upper half.
[[nodiscard]] constexpr leading operator*(const leading& x, const leading& y) noexcept {
    if (x.significand == 0 || y.significand == 0) {
        return {0, x.is_within(0) || y.is_within(0) ? 0 : no_bits, 0, false};
    }
    const two_limbs product = multiply(x.significand, y.significand);
    const std::uint64_t error = x.error + y.error + 2;
    const int exponent = x.exponent + y.exponent + 64;
    const bool negative = x.negative != y.negative;
    if (product.high >> 63 != 0) {
        return {product.high, error, exponent, negative};
    }
    return {product.high << 1 | product.low >> 63, 2 * error, exponent - 1, negative};
}

// With x₂ = s₂ + δ₂ the quotient is off by at most (e₁ + e₂ s₁/s₂)/x₂. That is at most 2 (e₁ + e₂)/(1 - e₂/2^63) units
// of a quotient in [2^63, 2^64), and so for e₂ <= 2^40 at most 2 (e₁ + e₂) + (e₁ + e₂)/2^21; y is not 0.
[[nodiscard]] constexpr leading operator/(const leading& x, const leading& y) noexcept {
    if (x.significand == 0) {
        return {0, x.error, 0, false};
    }
    const bool less = x.significand < y.significand;
    const std::uint64_t quotient =
        less ? divide(x.significand, 0, y.significand) : divide(x.significand >> 1, x.significand << 63, y.significand);
    const std::uint64_t error = x.error + y.error;
    return {quotient, 2 * error + (error >> 21) + 2, x.exponent - y.exponent - (less ? 64 : 63),
            x.negative != y.negative};
}

[[nodiscard]] constexpr leading operator+(const leading& x, const leading& y) noexcept {
    if (x.significand == 0 || y.significand == 0) {
        const bool known = x.is_within(no_bits - 1) && y.is_within(no_bits - 1);
        return !known ? leading{0, no_bits, 0, false} : x.significand == 0 ? y : x;
    }
    const bool x_first = x.exponent != y.exponent ? x.exponent > y.exponent : x.significand >= y.significand;
    const leading& large = x_first ? x : y;
    const leading& small = x_first ? y : x;
    const int down = large.exponent - small.exponent;
    const std::uint64_t shifted = down < 64 ? small.significand >> down : 0;
    const std::uint64_t error = large.error + (down == 0 ? small.error : (down < 64 ? small.error >> down : 0) + 2);
    if (large.negative == small.negative) {
        const std::uint64_t sum = large.significand + shifted;
        if (sum < shifted) {
            return {sum >> 1 | std::uint64_t{1} << 63, error / 2 + 2, large.exponent + 1, large.negative};
        }
        return {sum, error, large.exponent, large.negative};
    }
    const std::uint64_t difference = large.significand - shifted;
    const int zeros = std::countl_zero(difference);
    if (zeros > 40 || error >> 20 != 0) {
        return {0, no_bits, 0, false};
    }
    return {difference << zeros, error << zeros, large.exponent - zeros, large.negative};
}

// √x, x >= 0. √(s 2^64) has the derivative 2^64/(2√(s 2^64)) <= 1 in s, and square_root is off by at most 1.
[[nodiscard]] constexpr leading square_root(const leading& x) noexcept {
    if (x.significand == 0) {
        return x;
    }
    const bool odd = x.exponent % 2 != 0;
    const std::uint64_t root =
        odd ? square_root(x.significand >> 1, x.significand << 63) : square_root(x.significand, 0);
    return {root, x.error + 1, (x.exponent - (odd ? 63 : 64)) / 2, false};
}

} // namespace graze::inline v0_1::detail
