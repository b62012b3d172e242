// From exact values to a number type, each component correctly rounded once.
//
// A type whose values aren't binary floating-point numbers has a specialisation of converter, in its own header or
// in its translation unit.
#pragma once

#include "exact_view.hpp"

#include <limits>

namespace compare {

// The format of a binary floating type.
template <class T>
[[nodiscard]] constexpr binary_format format_of() {
    using limits = std::numeric_limits<T>;
    static_assert(limits::is_specialized && limits::radix == 2 && !limits::is_exact && !limits::is_integer,
                  "not a binary floating type: specialise compare::converter");
    return {limits::digits, limits::min_exponent, limits::max_exponent};
}
#ifdef __SIZEOF_FLOAT128__
template <>
[[nodiscard]] constexpr binary_format format_of<__float128>() { // std::numeric_limits knows it in GNU modes only
    return {113, -16381, 16384};
}
#endif

// x · 2^exponent, exact where the result is representable: every step goes straight towards it.
template <class T>
[[nodiscard]] T times_power_of_two(T x, long exponent) {
    const T two(2), half = T(1) / two;
    const T large(static_cast<float>(1 << 20)), small = T(1) / large;
    for (; exponent >= 20; exponent -= 20) {
        x = x * large;
    }
    for (; exponent <= -20; exponent += 20) {
        x = x * small;
    }
    for (; exponent > 0; --exponent) {
        x = x * two;
    }
    for (; exponent < 0; ++exponent) {
        x = x * half;
    }
    return x;
}

// A number of at most as many bits as T has.
template <class T>
[[nodiscard]] T value_of(const binary_number& x) {
    T magnitude(0);
    if (x.infinite) {
        magnitude = T(std::numeric_limits<double>::infinity());
    } else {
        const T half_digit(65536.0F); // its factors and terms are int, which every type takes
        for (const std::uint32_t digit : x.significand.digits) {
            magnitude = magnitude * half_digit + T(static_cast<int>(digit >> 16U));
            magnitude = magnitude * half_digit + T(static_cast<int>(digit & 0xffffU));
        }
        magnitude = times_power_of_two(magnitude, x.exponent);
    }
    return x.significand.negative ? T(-magnitude) : magnitude;
}

// static T from(const exact_view&): the value of T nearest to it (for an interval type, the smallest that encloses it).
template <class T>
struct converter {
    [[nodiscard]] static T from(const exact_view& x) { return value_of<T>(x.rounded(format_of<T>())); }
};

template <class T>
[[nodiscard]] T convert(const exact_view& x) {
    return converter<T>::from(x);
}

} // namespace compare
