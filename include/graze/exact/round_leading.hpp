// From the leading bits of a number to the float or double that it is rounded to. Where they leave this open, exactly
// one boundary is in question.
#pragma once

#include <graze/exact/leading.hpp>
#include <graze/exact/rounding.hpp>

#include <algorithm>
#include <optional>

namespace graze::inline v0_1::detail {

// The largest error of an estimate that can be rounded to T. Even with a quotient's error and 4 bits more, at most one
// boundary of T is in question, since boundaries are 2^(63 - digits) units apart.
template <class T>
inline constexpr std::uint64_t largest_error = std::uint64_t{1} << (59 - std::numeric_limits<T>::digits);

// The number in T that x is rounded to. x is not 0 and its error is at most 2 (largest_error + 2). against(m, e) is the
// sign of |x| - m 2^e.
template <class T, class Against>
[[nodiscard]] constexpr T round_estimate(const leading& x, rounding mode, Against against) {
    constexpr binary_format format = format_of<T>;
    // |x| lies in [low, low + width] 2^exponent, low >= 2^63.
    std::uint64_t low = x.significand - x.error;
    std::uint64_t width = 2 * x.error;
    int exponent = x.exponent;
    if (low >> 63 == 0) {
        low <<= 1;
        width <<= 1;
        --exponent;
    }
    const int unit = std::max(exponent + 63 - format.precision, format.lowest - 1); // the exponent of half a last place
    cut_off cut{0, unit, true};
    const int down = unit - exponent;
    if (unit + 1 <= format.highest && down <= 64) {
        const bool whole = down == 64; // below the smallest number, or nearly half of it
        cut.halves = whole ? 0 : low >> down;
        const std::uint64_t rest = whole ? low : low & ((std::uint64_t{1} << down) - 1);
        const std::uint64_t to_next = whole ? 0 - low : (std::uint64_t{1} << down) - rest;
        if (width >= to_next) {
            const int sign = against(cut.halves + 1, unit);
            cut.halves += sign >= 0 ? 1U : 0U;
            cut.more = sign != 0;
        } else if (rest == 0) {
            cut.more = against(cut.halves, unit) != 0;
        }
    }
    return from_bits<T>(rounded_bits(format, cut, x.negative, mode), x.negative);
}

// (p + q√d)/r · 2^scale rounded, from the leading bits of p, q, √d and r; empty if they leave it open.
template <class T>
[[nodiscard, gnu::noinline]] constexpr std::optional<T>
round_leading(const leading& p, const leading& q, const leading& root, const leading& r, int scale, rounding mode) {
    leading value = p + q * root;
    if (value.significand == 0 || !value.is_within(largest_error<T>)) {
        return std::nullopt;
    }
    value = value / r;
    value.exponent += scale;
    bool doubtful = false;
    const T nearest = round_estimate<T>(value, mode, [&](std::uint64_t, int) {
        doubtful = true;
        return 0;
    });
    return doubtful ? std::nullopt : std::optional<T>(nearest);
}

} // namespace graze::inline v0_1::detail
