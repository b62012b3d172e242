// Quotients and square roots of 128-bit numbers, to 64 bits: the counterpart of wide_multiply.
#pragma once

#include <graze/machine/wide_multiply.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

// floor((high 2^64 + low)/divisor) for high < divisor and divisor >= 2^63, in 32-bit digits (Knuth, The Art of Computer
// Programming 2, 4.3.1, algorithm D). Used where there is no 128-bit type; tested everywhere.
[[nodiscard]] constexpr std::uint64_t divide_portable(std::uint64_t high, std::uint64_t low,
                                                      std::uint64_t divisor) noexcept {
    constexpr std::uint64_t base = std::uint64_t{1} << 32;
    const std::uint64_t d1 = divisor >> 32;
    const std::uint64_t d0 = divisor % base;
    const auto digit = [&](std::uint64_t above, std::uint64_t next) {
        std::uint64_t q = above / d1;
        std::uint64_t rest = above % d1;
        while (q >= base || q * d0 > (rest << 32 | next)) { // twice at most
            --q;
            rest += d1;
            if (rest >= base) {
                break;
            }
        }
        return q;
    };
    const std::uint64_t q1 = digit(high, low >> 32);
    const std::uint64_t middle = (high << 32 | low >> 32) - q1 * divisor; // modulo 2^64, of which it has fewer bits
    const std::uint64_t q0 = digit(middle, low % base);
    return q1 << 32 | q0;
}

// The same, by the machine's own division if it has one.
[[nodiscard]] constexpr std::uint64_t divide(std::uint64_t high, std::uint64_t low, std::uint64_t divisor) noexcept {
#if defined(__SIZEOF_INT128__)
    return static_cast<std::uint64_t>((static_cast<uint128>(high) << 64 | low) / divisor);
#else
    return divide_portable(high, low, divisor);
#endif
}

// floor(√x): digit by digit, or at run time from the machine's root, corrected whatever its rounding was.
[[nodiscard]] constexpr std::uint64_t square_root(std::uint64_t x) noexcept {
    std::uint64_t root = 0;
    if (!std::is_constant_evaluated()) {
        root = static_cast<std::uint32_t>(std::min(std::sqrt(static_cast<double>(x)), 4294967295.0));
        while (root * root > x) {
            --root;
        }
        while (x - root * root > 2 * root) {
            ++root;
        }
        return root;
    }
    for (std::uint64_t bit = std::uint64_t{1} << 62; bit != 0; bit >>= 2) {
        const std::uint64_t trial = root + bit;
        root >>= 1;
        if (x >= trial) {
            x -= trial;
            root += bit;
        }
    }
    return root;
}

// √n to within 1, n = high 2^64 + low with high >= 2^62 (so that the root has 64 bits).
//
// With s = floor(√high) and √n = 2^32 s + δ, 0 <= δ < 2^32, one step of Newton's method from 2^32 s gives y = (n - 2^64
// s²)/(2^33 s) = δ + δ²/(2^33 s), and δ² < 2^64 <= 2^33 s: y - 1 < δ <= y. The quotient q below is in (y - 1, y].
[[nodiscard]] constexpr std::uint64_t square_root(std::uint64_t high, std::uint64_t low) noexcept {
    const std::uint64_t root = square_root(high);
    const std::uint64_t rest = high - root * root; // at most 2 root
    const std::uint64_t q = (rest << 31 | low >> 33) / root;
    return (root << 32) + (q >> 32 == 0 ? q : 0xffffffffU);
}

} // namespace graze::inline v0_1::detail
