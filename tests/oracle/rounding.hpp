// Whether a float or a double is what an exact real number is rounded to, by the two boundaries around it.
#pragma once

#include "surd.hpp"

#include <cmath>
#include <concepts>
#include <limits>

namespace oracle {

enum class direction { nearest, downward, upward };

// |y| exactly; of an infinity, the power of two that follows the largest number.
template <std::floating_point T>
mpq_class magnitude_of(T y) {
    if (std::isinf(y)) {
        return mpq_class(mpz_class(1) << std::numeric_limits<T>::max_exponent);
    }
    return mpq_class(static_cast<double>(std::fabs(y)));
}

template <std::floating_point T>
bool is_even(T y) {
    if constexpr (sizeof(T) == 4) {
        return (std::bit_cast<std::uint32_t>(y) & 1U) == 0;
    } else {
        return (std::bit_cast<std::uint64_t>(y) & 1U) == 0;
    }
}

// An exact zero is rounded to +0; what is not zero keeps its sign.
template <std::floating_point T>
bool is_rounded(const surd& x, T y, direction to = direction::nearest) {
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
    if (to == direction::nearest) {
        if (size != 0) {
            const mpq_class middle = (magnitude_of(size) + magnitude_of(std::nextafter(size, T(0)))) / 2;
            const int low = compare(magnitude, middle);
            if (low < 0 || (low == 0 && !is_even(size))) {
                return false;
            }
        }
        if (size == infinity) {
            return true;
        }
        const mpq_class middle = (magnitude_of(size) + magnitude_of(std::nextafter(size, infinity))) / 2;
        const int high = compare(magnitude, middle);
        return high < 0 || (high == 0 && is_even(size));
    }
    if ((to == direction::downward) == (sign > 0)) { // towards zero: the largest that is not above
        return size != infinity && compare(magnitude, magnitude_of(size)) >= 0 &&
               (size == std::numeric_limits<T>::max() ||
                compare(magnitude, magnitude_of(std::nextafter(size, infinity))) < 0);
    }
    return size != 0 && (size == infinity || compare(magnitude, magnitude_of(size)) <= 0) &&
           (size == infinity ? compare(magnitude, magnitude_of(std::numeric_limits<T>::max())) > 0
                             : compare(magnitude, magnitude_of(std::nextafter(size, T(0)))) > 0);
}

} // namespace oracle
