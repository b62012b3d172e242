// Two doubles between which an event's exact time lies: what nearly every comparison of times is decided by.
#pragma once

#include <graze/formula/quadratic.hpp>
#include <graze/formula/roots.hpp>
#include <graze/number/approximate.hpp>
#include <graze/number/fence.hpp>

#include <cmath>
#include <limits>

namespace graze::detail {

// 0 <= lower <= τ <= upper, but for an upper bound that is not known: it is then the largest double, and τ may be
// beyond. No lower bound and no finite time in T is above that; an infinity would be no value at all under -ffast-math.
struct enclosure {
    static constexpr double unknown = std::numeric_limits<double>::max();

    double lower = 0;
    double upper = unknown;
};

// A quotient and a root that have been checked by products. Neither the hardware's rounding nor an estimate that the
// compiler put in their place matters: each is right to 2^-47, relatively, or `good` is false.
struct checked_root {
    double root, time, denominator;
    bool good;
};
[[nodiscard]] inline checked_root check_root(double c, double minus_h, double discriminant) noexcept {
    const double root = fence(std::sqrt(discriminant));
    const double denominator = fence(minus_h + root);
    const double time = fence(root_stable{}(c, -minus_h, root));
    const bool good = std::fabs(root * root - discriminant) <= 0x1p-48 * discriminant &&
                      std::fabs(time * denominator - c) <= 0x1p-48 * c;
    return {root, time, denominator, good};
}

// Around τ = c/d, d = -h + √D, from values ĉ, ĥ, D̂ whose errors are at most error_c, error_h and error_d, where
// error_root >= error_d + error_h √D and D̂ > 8 error_root; all positive, no over- or underflow. With ŝ, d̂, t̂ the root,
// the denominator and the time as computed and checked:
//   |√D - ŝ| = |D - ŝ²|/(√D + ŝ) <= error_d/ŝ + 2^-48 ŝ,
//   |d - d̂| <= e := error_root/ŝ + 2^-47 d̂ <= d̂/7, since ŝ <= d̂,
//   |τ - t̂| = |c - t̂ d|/d <= (error_c + 2^-48 ĉ + t̂ e)/(d̂ - e) <= 7/6 (error_c + t̂ error_root/ŝ)/d̂ + 2^-46 t̂.
// What is taken, 3/2 of the first and 2^-45 of the second, covers the roundings of the expression itself. Without a
// certain enclosure the upper bound is unknown and the lower one 0.
[[nodiscard]] inline enclosure enclose(double c, double h, double discriminant, double error_c,
                                       double error_root) noexcept {
    if (!(discriminant > 8 * error_root)) {
        return {};
    }
    const checked_root r = check_root(c, -h, discriminant);
    if (!r.good) {
        return {};
    }
    const double error = 1.5 * (error_c + r.time * (error_root / r.root)) / r.denominator + 0x1p-45 * r.time;
    const double lower = r.time - error;
    return {lower > 0 ? lower : 0, r.time + error};
}

// Around the smaller root of an exact quadratic with a > 0, h < 0, c >= 0 and D >= 0 whose unit of time is 2^unit.
// Every approximation is right to 2^-50, no two of them cancel: τ is right to 2^-45.
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
    const double root = fence(std::sqrt(d.significand));
    if (!(std::fabs(root * root - d.significand) <= 0x1p-48 * d.significand)) {
        return {};
    }
    // Both terms of -h + √D at the exponent of -h, the larger one; what then underflows is negligible.
    const int down = d.exponent / 2 - g.exponent;
    const double denominator = fence(g.significand + (down < -900 ? 0.0 : root * power_of_two(down)));
    const double time = fence(c.significand / denominator);
    const long power = static_cast<long>(c.exponent) - g.exponent + unit;
    if (!(std::fabs(time * denominator - c.significand) <= 0x1p-48 * c.significand) || power < -800 || power > 800) {
        return {};
    }
    const double scaled = time * power_of_two(static_cast<int>(power));
    return {scaled * (1 - 0x1p-44), scaled * (1 + 0x1p-44)};
}

} // namespace graze::detail
