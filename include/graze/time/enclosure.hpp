// Two doubles between which an event's exact time lies. They decide nearly every comparison of times.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/exact/binary.hpp>
#include <graze/formula/quadratic.hpp>
#include <graze/formula/roots.hpp>
#include <graze/machine/environment.hpp>
#include <graze/machine/fence.hpp>
#include <graze/machine/lanes.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace graze::inline v0_1::detail {

// near - error <= τ <= near + error, with these ends as computed in any rounding mode. An unknown error is the largest
// double, and τ may then be beyond. No finite time in T is; an infinity would be no value at all under -ffast-math.
// An error that is neither 0 nor unknown is larger than necessary by 2^-50 of near + error, and so by more than all
// roundings of these sums and of is_apart_from.
struct enclosure {
    static constexpr double unknown = std::numeric_limits<double>::max();

    double near = 0;
    double error = unknown;

    [[nodiscard]] constexpr bool is_known() const noexcept { return error < unknown; }
    // Whether it is a single number.
    [[nodiscard]] constexpr bool is_point() const noexcept { return bits_of(error) == 0; }
    [[nodiscard]] constexpr double lower() const noexcept { return as_stored(near - error); }
    [[nodiscard]] constexpr double upper() const noexcept { return as_stored(near + error); }

    // Whether no number lies in both. Then the times have the order of their nears. It takes half the additions of
    // comparing ends: |difference| - error, each right to 2^-52 of the larger near.
    [[nodiscard]] constexpr bool is_apart_from(const enclosure& y) const noexcept {
        const double difference = as_stored(near - y.near);
        const double distance = !std::is_constant_evaluated() ? std::fabs(difference)
                                : difference < 0              ? -difference
                                                              : difference;
        return as_stored(distance - error) > y.error;
    }
};

// At least 1/x and at most 9/8 of it, cheaper than a division: for x = 2^e (1 + f) it is 2^-e (1 - f/2), and (1 + f)(1
// - f/2) = 1 + f (1 - f)/2. x is positive, normal and below 2^1022.
[[nodiscard]] inline double inverse_or_more(double x) noexcept {
    return std::bit_cast<double>(0x7fe0000000000000U - bits_of(x));
}

// Around τ = c/d, d = -h + √D, from values ĉ, ĥ and D̂ = ĥ² - âĉ > 0 whose errors are at most error_c, error_h and
// error_d, where error_root >= error_d + error_h √D and D̂ > 8 error_root; all positive, no over- or underflow. The root
// ŝ and the time t̂ are right to 2^-47, relatively, since their squares and products say so where the compiler may have
// put an estimate in the place of the hardware's rounding. With d̂ = -ĥ + ŝ
//   |√D - ŝ| = |D - ŝ²|/(√D + ŝ) <= error_d/ŝ + 2^-48 ŝ,
//   |d - d̂| <= e := error_root/ŝ + 2^-47 d̂ <= d̂/7, since ŝ <= d̂,
//   |τ - t̂| = |c - t̂ d|/d <= (error_c + 2^-48 ĉ + t̂ e)/(d̂ - e) <= 7/6 (error_c + t̂ error_root/ŝ)/d̂ + 2^-46 t̂,
// and âĉ <= ĥ² <= d̂² (each but for 2^-50 of it) makes t̂/d̂ = ĉ/d̂² at most 1/â: the first is at most 7/6 (error_c +
// error_root/â)/ŝ. `error` is to be 3/2 of that bracket; it and 2^-45 in place of 2^-46 cover the roundings of the
// expression itself. Without a certain enclosure nothing is known.
//
// For c and d from lengths L and velocities V of a motion with L², V² > 2^-450 and L² V² < 2^570: D̂ > 2^-50 L² V², and
// ŝ is within 2^-500 and 2^287.
[[nodiscard]] inline enclosure enclose(double c, double h, double discriminant, double error) noexcept {
    const double root = settled(plain_sqrt(discriminant));
    const double denominator = settled(root - h);
    const double time = settled(root_stable{}(c, h, root));
    if constexpr (!has_error_free_doubles) {
        if (!(std::fabs(root * root - discriminant) <= 0x1p-48 * discriminant &&
              std::fabs(time * denominator - c) <= 0x1p-48 * c)) {
            return {};
        }
    }
    return {time, error * inverse_or_more(root) + 0x1p-45 * time};
}

// Around τ = c/d, d = -h + √D, as above but from any approximation of D, and close for a small √D too: with error_root
// >= error_d + error_h √D and D̂ > 8 error_root,
//   |τ - t̂| <= 7/6 (error_c + t̂ error_root/ŝ)/d̂ + 2^-46 t̂.
[[nodiscard]] inline enclosure enclose_closely(double c, double h, double discriminant, double error_c, double error_h,
                                               double error_d) noexcept {
    const double root = settled(plain_sqrt(discriminant));
    const double error_root = error_d + 1.01 * error_h * root;
    const double denominator = settled(root - h);
    const double time = settled(root_stable{}(c, h, root));
    if (!(8 * error_root < discriminant) ||
        !(has_error_free_doubles || (std::fabs(root * root - discriminant) <= 0x1p-48 * discriminant &&
                                     std::fabs(time * denominator - c) <= 0x1p-48 * c))) {
        return {};
    }
    const double of_root = time * (error_root * inverse_or_more(root));
    return {time, 1.25 * ((error_c + of_root) * inverse_or_more(denominator)) + 0x1p-45 * time};
}

// start + τ, with τ in the given enclosure. In any rounding mode a sum is off by at most 2^-52 of itself, and by what a
// mode turns into 0 if it is subnormal, as it does with a start that is a subnormal T.
template <class T>
[[nodiscard]] inline enclosure counted_from(double start, const enclosure& e) noexcept {
    constexpr double flushed = std::is_same_v<T, float> ? 0x1p-124 : 0x1p-1020;
    const double near = start + e.near;
    const double error = (1 + 0x1p-49) * e.error + (0x1p-48 * std::fabs(near) + flushed);
    return e.is_known() && error < 0x1p1000 ? enclosure{near, error} : enclosure{};
}

// Around the smaller root of an exact quadratic with a > 0, h < 0, c >= 0 and D >= 0 whose unit of time is 2^unit.
// Every approximation is right to 2^-50, no two of them cancel: τ is right to 2^-45.
// A point: they touch.
template <class Q>
[[nodiscard]] inline enclosure enclose(const Q& q, int unit) noexcept {
    if (sign(q.c) == 0) {
        return {0, 0};
    }
    const scaled_double c = approximate(q.c);
    const scaled_double g = approximate(-q.h);
    const auto exact_discriminant = q.h * q.h - q.a * q.c;
    scaled_double d = approximate(exact_discriminant);
    if (d.exponent % 2 != 0) {
        d = {2 * d.significand, d.exponent - 1};
    }
    const double root = settled(std::sqrt(d.significand));
    if (!(std::fabs(root * root - d.significand) <= 0x1p-48 * d.significand)) {
        return {};
    }
    // Both terms of -h + √D at the exponent of -h, the larger one; what then underflows is negligible.
    const int down = d.exponent / 2 - g.exponent;
    const double denominator = settled(g.significand + (down < -900 ? 0.0 : root * power_of_two(down)));
    const double time = settled(c.significand / denominator);
    const long power = static_cast<long>(c.exponent) - g.exponent + unit;
    if (!(std::fabs(time * denominator - c.significand) <= 0x1p-48 * c.significand) || power < -800 || power > 800) {
        return {};
    }
    const double scaled = time * power_of_two(static_cast<int>(power));
    return {scaled, scaled * 0x1p-44};
}

} // namespace graze::inline v0_1::detail
