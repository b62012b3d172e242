// 64 × 64 → 128 bits and carries: by a 128-bit type if there is one, otherwise by portable code.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace graze::inline v0_1::detail {

struct two_limbs {
    std::uint64_t low, high;
};

// x y in 32-bit halves. Used where there is no 128-bit type; tested everywhere.
[[nodiscard]] constexpr two_limbs multiply_portable(std::uint64_t x, std::uint64_t y) noexcept {
    constexpr std::uint64_t mask = 0xffffffffU;
    const std::uint64_t low = (x & mask) * (y & mask);
    const std::uint64_t cross0 = (x >> 32) * (y & mask) + (low >> 32); // at most 2^64 - 2^32: no carry is lost
    const std::uint64_t cross1 = (x & mask) * (y >> 32) + (cross0 & mask);
    return {cross1 << 32 | (low & mask), (x >> 32) * (y >> 32) + (cross0 >> 32) + (cross1 >> 32)};
}

#if defined(__SIZEOF_INT128__)
__extension__ typedef unsigned __int128 uint128;
__extension__ typedef __int128 int128;
#endif

[[nodiscard]] constexpr two_limbs multiply(std::uint64_t x, std::uint64_t y) noexcept {
#if defined(__SIZEOF_INT128__)
    const uint128 product = static_cast<uint128>(x) * y;
    return {static_cast<std::uint64_t>(product), static_cast<std::uint64_t>(product >> 64)};
#else
    return multiply_portable(x, y);
#endif
}

// x y + addend + carry_in, which never exceeds 128 bits.
[[nodiscard]] constexpr two_limbs multiply_add(std::uint64_t x, std::uint64_t y, std::uint64_t addend,
                                               std::uint64_t carry_in) noexcept {
#if defined(__SIZEOF_INT128__)
    const uint128 sum = static_cast<uint128>(x) * y + addend + carry_in;
    return {static_cast<std::uint64_t>(sum), static_cast<std::uint64_t>(sum >> 64)};
#else
    two_limbs product = multiply_portable(x, y);
    product.low += addend;
    product.high += product.low < addend ? 1U : 0U;
    product.low += carry_in;
    product.high += product.low < carry_in ? 1U : 0U;
    return product;
#endif
}

// x + y + carry, carry 0 or 1 in and out.
[[nodiscard]] constexpr std::uint64_t add_with_carry(std::uint64_t x, std::uint64_t y, std::uint64_t& carry) noexcept {
    const std::uint64_t partial = x + y;
    const std::uint64_t sum = partial + carry;
    carry = static_cast<std::uint64_t>(partial < x) | static_cast<std::uint64_t>(sum < partial);
    return sum;
}

// x y + addend + carry_in, or with -x y, as low + 2^64 high with -2^63 <= low < 2^63: |high| <= 2^62 + 1.
struct signed_limbs {
    std::int64_t low, high;
};
[[nodiscard]] constexpr signed_limbs multiply_add_balanced(std::int64_t x, std::int64_t y, std::int64_t addend,
                                                           std::int64_t carry_in, bool minus = false) noexcept {
#if defined(__SIZEOF_INT128__)
    const int128 product = static_cast<int128>(x) * y;
    const int128 sum = (minus ? -product : product) + addend + carry_in;
    const auto low = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum));
    return {low, static_cast<std::int64_t>(static_cast<std::uint64_t>(sum >> 64)) + (low < 0 ? 1 : 0)};
#else
    const auto ux = static_cast<std::uint64_t>(x);
    const auto uy = static_cast<std::uint64_t>(y);
    two_limbs product = multiply_portable(ux, uy);
    product.high -= (x < 0 ? uy : 0U) + (y < 0 ? ux : 0U);
    if (minus) {
        product.low = 0 - product.low;
        product.high = ~product.high + (product.low == 0 ? 1U : 0U);
    }
    for (const std::int64_t term : {addend, carry_in}) {
        const auto bits = static_cast<std::uint64_t>(term);
        product.low += bits;
        product.high += (product.low < bits ? 1U : 0U) + (term < 0 ? ~std::uint64_t{0} : 0U);
    }
    const auto low = static_cast<std::int64_t>(product.low);
    return {low, static_cast<std::int64_t>(product.high + (low < 0 ? 1U : 0U))};
#endif
}

// x + y + carry in the same form; |carry| <= 2.
[[nodiscard]] constexpr signed_limbs add_balanced(std::int64_t x, std::int64_t y, std::int64_t carry) noexcept {
#if defined(__SIZEOF_INT128__)
    const int128 sum = static_cast<int128>(x) + y + carry;
    const auto low = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum));
    return {low, static_cast<std::int64_t>(static_cast<std::uint64_t>(sum >> 64)) + (low < 0 ? 1 : 0)};
#else
    return multiply_add_balanced(1, y, x, carry);
#endif
}

} // namespace graze::inline v0_1::detail
