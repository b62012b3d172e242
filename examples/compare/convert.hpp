// From exact values to a number type, each component correctly rounded once.
//
// A type whose values aren't binary floating-point numbers has a specialisation of converter, in its own header
// (convert_gmp.hpp, convert_cgal.hpp, ...) or in its translation unit.
#pragma once

#include "rounding.hpp"

#include <cstdint>
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

// static T from(const exact&): the value of T nearest to it (for an interval type, the smallest that encloses it).
template <class T>
struct converter {
    [[nodiscard]] static T from(const exact& x) {
        const rounded_value r = round_to(x, format_of<T>());
        T magnitude(0);
        if (r.infinite) {
            magnitude = T(std::numeric_limits<double>::infinity());
        } else {
            const T limb(65536.0F);
            const auto bits = static_cast<long>(r.significand == 0 ? 0 : msb(r.significand) + 1);
            for (long low = (bits + 15) / 16 * 16 - 16; low >= 0; low -= 16) {
                const auto chunk = static_cast<int>((r.significand >> low) & 0xffff);
                magnitude = magnitude * limb + T(chunk);
            }
            magnitude = times_power_of_two(magnitude, r.exponent);
        }
        return r.negative ? T(-magnitude) : magnitude;
    }
};

template <>
struct converter<exact> {
    [[nodiscard]] static exact from(const exact& x) { return x; }
};

template <class T>
[[nodiscard]] T convert(const exact& x) {
    return converter<T>::from(x);
}

template <class T, int N>
[[nodiscard]] graze::vec<N, T> convert(const graze::vec<N, exact>& x) {
    return graze::make_vec<N>([&](int i) { return convert<T>(x[i]); });
}

// The mass is left at 1: convert inverse_mass for graze::solve_with_inverse_masses.
template <class T, int N>
[[nodiscard]] graze::ball<N, T> convert(const exact_ball<N>& b) {
    return {convert<T>(b.shape.position), convert<T>(b.shape.velocity), convert<T>(b.shape.radius), T(1)};
}

template <class T, int N>
[[nodiscard]] graze::plane<N, T> convert(const graze::plane<N, exact>& p) {
    return {convert<T>(p.point), convert<T>(p.normal)};
}

template <class T, int N>
[[nodiscard]] graze::wall<N, T> convert(const graze::wall<N, exact>& w) {
    graze::wall<N, T> result{convert<T>(w.corner), {}};
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        result.edge[i] = convert<T>(w.edge[i]);
    }
    return result;
}

} // namespace compare
