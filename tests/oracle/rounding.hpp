// Whether a float or a double is the rounded value of an exact real number, by the two boundaries around it.
#pragma once

#include "surd.hpp"

#include <cmath>
#include <concepts>
#include <limits>

namespace oracle {

enum class direction { nearest, downward, upward };

template <std::floating_point T>
bool is_even(T y) {
    if constexpr (sizeof(T) == 4) {
        return (std::bit_cast<std::uint32_t>(y) & 1U) == 0;
    } else {
        return (std::bit_cast<std::uint64_t>(y) & 1U) == 0;
    }
}

// |y| = significand · 2^exponent with all the bits of the format; for an infinity, the power of two that follows the
// largest number.
struct binary_number {
    mpz_class significand;
    int exponent;
    bool below_is_near; // whether the next number below is half a unit away
};
template <std::floating_point T>
binary_number taken_apart(T y) {
    using limits = std::numeric_limits<T>;
    constexpr int lowest = limits::min_exponent - limits::digits;
    if (std::isinf(y)) {
        return {mpz_class(1) << limits::digits, limits::max_exponent - limits::digits, false};
    }
    int exponent = 0;
    (void)std::frexp(y, &exponent);
    const int unit = y == 0 ? lowest : std::max(exponent - limits::digits, lowest);
    const auto significand = static_cast<std::uint64_t>(std::ldexp(static_cast<double>(std::fabs(y)), -unit / 2) *
                                                        std::ldexp(1.0, -unit + unit / 2));
    return {mpz_class(static_cast<unsigned long>(significand)), unit,
            unit > lowest && significand == std::uint64_t{1} << (limits::digits - 1)};
}

// The sign of x - m 2^exponent.
inline int compare(const surd& x, const mpz_class& m, int exponent) {
    if (exponent >= 0) {
        return sign_of(mpz_class(x.p - ((m * x.r) << static_cast<unsigned>(exponent))), x.q, x.d);
    }
    const auto up = static_cast<unsigned>(-exponent);
    return sign_of(mpz_class((x.p << up) - m * x.r), mpz_class(x.q << up), x.d);
}

enum class verdict { wrong, right, tied }; // tied: right, and exactly in the middle between two numbers

// Whether y is x rounded, ties to even. An exact zero rounds to +0; any other number keeps its sign.
template <std::floating_point T>
verdict judged(const surd& x, T y) {
    const int sign = sign_of(x);
    if (std::isnan(y) || std::signbit(y) != (sign < 0)) {
        return verdict::wrong;
    }
    if (sign == 0) {
        return y == 0 ? verdict::right : verdict::wrong;
    }
    const surd magnitude{sign * x.p, sign * x.q, x.d, x.r};
    const T size = std::fabs(y);
    const binary_number b = taken_apart(size);
    const auto side = [&](int sign_beyond) {
        return sign_beyond > 0 || (sign_beyond == 0 && !is_even(size)) ? verdict::wrong
               : sign_beyond == 0                                      ? verdict::tied
                                                                       : verdict::right;
    };
    if (size != 0) {
        const verdict low =
            side(b.below_is_near ? -compare(magnitude, mpz_class(4 * b.significand - 1), b.exponent - 2)
                                 : -compare(magnitude, mpz_class(2 * b.significand - 1), b.exponent - 1));
        if (low != verdict::right) {
            return low;
        }
    }
    if (std::isinf(size)) {
        return verdict::right;
    }
    return side(compare(magnitude, mpz_class(2 * b.significand + 1), b.exponent - 1));
}

// The same in any direction.
template <std::floating_point T>
bool is_rounded(const surd& x, T y, direction to = direction::nearest) {
    if (to == direction::nearest) {
        return judged(x, y) != verdict::wrong;
    }
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const int sign = sign_of(x);
    if (std::isnan(y) || std::signbit(y) != (sign < 0)) {
        return false;
    }
    if (sign == 0) {
        return y == 0;
    }
    const surd magnitude{sign * x.p, sign * x.q, x.d, x.r};
    const T size = std::fabs(y);
    const auto against = [&](T z) {
        const binary_number b = taken_apart(z);
        return compare(magnitude, b.significand, b.exponent);
    };
    if ((to == direction::downward) == (sign > 0)) { // towards zero: the largest number that is not above
        return size != infinity && against(size) >= 0 &&
               (size == std::numeric_limits<T>::max() || against(std::nextafter(size, infinity)) < 0);
    }
    return size != 0 && (size == infinity || against(size) <= 0) &&
           (size == infinity ? against(std::numeric_limits<T>::max()) > 0 : against(std::nextafter(size, T(0))) > 0);
}

} // namespace oracle
