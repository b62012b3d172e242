// A bounded number times a power of two, rounded once.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/exact/binary.hpp>
#include <graze/exact/round_leading.hpp>
#include <graze/filter/static_filter.hpp>
#include <graze/machine/fence.hpp>
#include <graze/time/certain_rounding.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

// The leading bits of high + low, high the nearest double and within 2^±900, with an error of at most 2^-60 of it: in
// units of the last of 64 bits low is at most 2^10, and taking low and error to integers costs one unit each.
[[nodiscard]] inline leading leading_of(const exact_pair<double>& x, double error) noexcept {
    const binary b = split(x.value);
    const int exponent = b.exponent - 11;
    const bool negative = b.significand < 0;
    const auto magnitude = static_cast<std::uint64_t>(negative ? -b.significand : b.significand) << 11;
    const double unit = power_of_two(-exponent);
    const auto low = static_cast<std::int64_t>((negative ? -x.error : x.error) * unit);
    const auto off = static_cast<std::uint64_t>(error * unit) + 2;
    const std::uint64_t sum = magnitude + static_cast<std::uint64_t>(low);
    if (sum >> 63 == 0) { // just below a power of two
        return {sum << 1, 2 * off, exponent - 1, negative};
    }
    return {sum, off, exponent, negative};
}

// x 2^scale rounded; none where its bounds leave a doubt.
template <class T>
[[nodiscard, gnu::noinline]] certain_number<T> rounded_scaled(const bounded<double>& x, int scale,
                                                              rounding mode) noexcept {
    const auto sum = two_sum(x.high, x.low);
    const double size = absolute(sum.value);
    if (!(within_powers<-900, 900>(size) && x.error < 0x1p-60 * size)) {
        return {};
    }
    leading value = leading_of(sum, x.error);
    value.exponent += scale;
    bool doubtful = false;
    const T nearest = round_estimate<T>(value, mode, [&](std::uint64_t halves, int) {
        if (mode == rounding::nearest && halves % 2 == 0) {
            return 1; // on either side of a number of T it is the nearest
        }
        doubtful = true;
        return 0;
    });
    return {nearest, !doubtful};
}

// x 2^scale rounded to nearest by one comparison of its ends, if x is a normal number of T and the result is no
// subnormal one; for floats only if nothing is scaled. Positive results below 2^-1076 are rounded to 0, from 2^1024 on
// to infinity. On the clock of a flight a time may be negative; it does not overflow then. Whether a time becomes 0 is
// no branch: it is known last, after all else that a pair needs.
template <class T>
[[nodiscard]] inline certain_number<T> rounded_quickly(const bounded<double>& x, int scale) noexcept {
    if (scale == 0 || std::is_same_v<T, double>) {
        const ends<double> interval = ends_of<T>(x);
        if (agree<T>(interval)) {
            if (scale == 0) {
                return {static_cast<T>(interval.upper), true};
            }
            const std::uint64_t bits = bits_of(interval.upper);
            const int unscaled = static_cast<int>(bits >> 52 & 0x7ff);
            const int exponent = unscaled + scale;
            const bool vanishes = exponent < -53;
            if (all_hold(unscaled != 0, exponent < 0x7ff, (exponent > 0) | (vanishes & (bits >> 63 == 0)))) [[likely]] {
                const auto shift = static_cast<std::uint64_t>(static_cast<std::int64_t>(scale)) << 52;
                const std::uint64_t kept = opaque(std::uint64_t{vanishes} - 1);
                return {static_cast<T>(std::bit_cast<double>((bits + shift) & kept)), true};
            }
            if (exponent >= 0x7ff && unscaled != 0 && bits >> 63 == 0) {
                return {static_cast<T>(hidden_infinity()), true};
            }
        }
    }
    return rounded_scaled<T>(x, scale, rounding::nearest);
}

// A time in units of 2^unit, if good; otherwise nothing is known of it.
struct approached_time {
    bounded<double> time{};
    int unit = 0;
    bool good = false;
};

// Such a time rounded, if good; none where a doubt is left.
template <class T>
[[nodiscard]] inline certain_number<T> round_approached(const approached_time& t, rounding mode) noexcept {
    if (!t.good) {
        return {};
    }
    if (mode == rounding::nearest) {
        return rounded_quickly<T>(t.time, t.unit);
    }
    return t.unit == 0 && std::is_same_v<T, double> ? certainly_rounded<T>(t.time, mode)
                                                    : rounded_scaled<T>(t.time, t.unit, mode);
}

} // namespace graze::inline v0_1::detail
