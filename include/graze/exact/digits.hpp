// Sums and products of numbers as rows of signed digits: what big_integer computes with.
#pragma once

#include <graze/machine/wide_multiply.hpp>

#include <cstdint>
#include <utility>

namespace graze::inline v0_1::detail {

// Σ digit[i] 2^(64 i), i < count, with digits in [-2^63, 2^63). A non-owning view.
struct digit_row {
    const std::int64_t* digit;
    int count;
};

// Writes significand · 2^shift in two digits, 0 <= shift < 64. The power is taken in two factors, since 2^63 is not a
// digit.
constexpr void write_shifted(std::int64_t* digit, std::int64_t significand, int shift) noexcept {
    const std::int64_t first = std::int64_t{1} << shift / 2, second = std::int64_t{1} << (shift - shift / 2);
    const auto half = multiply_add_balanced(significand, first, 0, 0);
    const auto low = multiply_add_balanced(half.low, second, 0, 0);
    digit[0] = low.low;
    digit[1] = half.high * second + low.high;
}

// Writes `count` limbs in two's complement, the lowest first, in count + 1 digits: a negative digit borrows from the
// next limb.
constexpr void write_limbs(std::int64_t* digit, const std::uint64_t* limb, int count) noexcept {
    const std::uint64_t extension = limb[count - 1] >> 63 != 0 ? ~std::uint64_t{0} : 0;
    std::uint64_t borrowed = 0;
    for (int i = 0; i <= count; ++i) {
        const std::uint64_t next = (i < count ? limb[i] : extension) + borrowed;
        borrowed = next < borrowed || next >> 63 != 0 ? 1 : 0;
        digit[i] = static_cast<std::int64_t>(next);
    }
}

// Writes x ± y 2^(64 shift), shift >= 0, in one digit more than the longer of the two needs.
constexpr void write_sum(std::int64_t* digit, digit_row x, digit_row y, int shift, bool subtract) noexcept {
    const std::int64_t opposite = subtract ? 1 : 0;
    const int end = y.count + shift;
    const int common = x.count < end ? x.count : end;
    int i = 0;
    for (; i < shift; ++i) {
        digit[i] = i < x.count ? x.digit[i] : 0;
    }
    std::int64_t carry = 0;
    const auto put = [&](std::int64_t a, std::int64_t b) { // -b is ~b + 1
        const auto t = add_balanced(a, b ^ -opposite, carry + opposite);
        digit[i] = t.low;
        carry = t.high;
    };
    for (; i < common; ++i) {
        put(x.digit[i], y.digit[i - shift]);
    }
    for (; i < end; ++i) {
        put(0, y.digit[i - shift]);
    }
    for (; i < x.count; ++i) {
        put(x.digit[i], 0);
    }
    digit[i] = carry;
}

// Adds ±factor · y to the digits from `sum` on and returns the carry.
[[nodiscard]] constexpr std::int64_t add_multiple(std::int64_t* sum, std::int64_t factor, digit_row y,
                                                  bool subtract) noexcept {
    std::int64_t carry = 0;
    for (int j = 0; j < y.count; ++j) {
        const auto t = multiply_add_balanced(factor, y.digit[j], sum[j], carry, subtract);
        sum[j] = t.low;
        carry = t.high;
    }
    return carry;
}

// Writes x y in x.count + y.count digits.
constexpr void write_product(std::int64_t* digit, digit_row x, digit_row y) noexcept {
    if (x.count > y.count) {
        std::swap(x, y); // fewer rows, and longer ones
    }
    std::int64_t carry = 0;
    for (int j = 0; j < y.count; ++j) {
        const auto t = multiply_add_balanced(x.digit[0], y.digit[j], 0, carry);
        digit[j] = t.low;
        carry = t.high;
    }
    digit[y.count] = carry;
    for (int i = 1; i < x.count; ++i) {
        digit[i + y.count] = x.digit[i] != 0 ? add_multiple(digit + i, x.digit[i], y, false) : 0;
    }
}

// Adds ±x y to the digits from `sum` on, which must have room for the carries.
constexpr void add_product(std::int64_t* sum, digit_row x, digit_row y, bool subtract) noexcept {
    if (x.count > y.count) {
        std::swap(x, y);
    }
    for (int i = 0; i < x.count; ++i, ++sum) {
        if (const std::int64_t factor = x.digit[i]; factor != 0) {
            std::int64_t carry = add_multiple(sum, factor, y, subtract);
            for (std::int64_t* above = sum + y.count; carry != 0; ++above) {
                const auto t = add_balanced(*above, 0, carry);
                *above = t.low;
                carry = t.high;
            }
        }
    }
}

} // namespace graze::inline v0_1::detail
