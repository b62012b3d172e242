// The requirements on every adapted number type.
#pragma once

#include <graze/number/sqrt_extension.hpp>
#include <graze/number/traits.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

namespace adapter {

enum class kind { exact_ring, exact_field, inexact_field };

template <class T, kind K, bool HasSqrt, bool HasFma>
consteval bool satisfies() {
    static_assert(graze::number<T>);
    static_assert(graze::exact_number<T> == (K != kind::inexact_field));
    static_assert(graze::field_number<T> == (K != kind::exact_ring));
    static_assert(graze::has_sqrt<T> == HasSqrt);
    static_assert(graze::has_fma<T> == HasFma);
    static_assert((graze::number_traits<T>::digits > 0) == (K == kind::inexact_field));
    if constexpr (graze::exact_number<T> && !HasSqrt) {
        static_assert(std::is_same_v<graze::root_type<T>, graze::sqrt_extension<T>>);
    } else if constexpr (HasSqrt) {
        static_assert(std::is_same_v<graze::root_type<T>, T>);
    }
    return true;
}

// Whether |x| <= bound.
template <class T>
bool is_within(const T& x, double bound) {
    if (graze::sign(x) == 0) {
        return true;
    }
    if constexpr (requires { static_cast<double>(x); }) {
        return std::abs(static_cast<double>(x)) <= bound;
    } else if constexpr (requires { to_double(x); }) {
        return std::abs(to_double(x)) <= bound;
    } else {
        return false;
    }
}

// Ring arithmetic, signs and the name, on whole numbers, which every type holds exactly. unit: the relative error
// allowed for quotients and roots that have an exact result; 0 unless the type does not round correctly.
template <class T>
void check(std::string_view name, double unit = 0) {
    CHECK(std::string_view(graze::number_traits<T>::name) == name);
    for (int x = -9; x <= 9; ++x) {
        CHECK(graze::sign(T(x)) == (x > 0) - (x < 0));
        CHECK(graze::sign(T(graze::twice(T(x)) - T(2 * x))) == 0);
        CHECK(graze::sign(T(-T(x) - T(-x))) == 0);
        for (int y = -9; y <= 9; ++y) {
            CHECK(graze::sign(T(T(x) + T(y) - T(x + y))) == 0);
            CHECK(graze::sign(T(T(x) * T(y) - T(x * y))) == 0);
            CHECK(graze::sign(T(T(x) - T(y))) == (x > y) - (x < y));
            if constexpr (graze::field_number<T>) {
                if (y != 0) {
                    CHECK(is_within(T(T(x * y) / T(y) - T(x)), unit * std::abs(x)));
                }
            }
        }
    }
    if constexpr (graze::has_sqrt<T>) {
        for (int x = 0; x <= 20; ++x) {
            CHECK(is_within(T(graze::square_root(T(x * x)) - T(x)), unit * x));
        }
    }
}

// (1 + u)(1 - u) - 1 = -u², which a product that is rounded first loses; u = 2^-digits + 1.
template <class T>
void check_fma() {
    T u(1);
    for (int i = 0; i < graze::number_traits<T>::digits - 1; ++i) {
        u = u / T(2);
    }
    const T above = T(1) + u, below = T(1) - u;
    CHECK(graze::sign(T(above * below - T(1))) == 0);
    CHECK(graze::sign(T(graze::number_traits<T>::fma(above, below, T(-1)) + u * u)) == 0);
}

// The type has the stated digits and no more: 1 + 2^-(digits - 1) is not 1, and 1 + 2^-(digits + slack) is.
template <class T>
void check_digits(int slack = 0) {
    T u(1);
    for (int i = 0; i < graze::number_traits<T>::digits - 1; ++i) {
        u = u / T(2);
    }
    CHECK(graze::sign(T(T(1) + u - T(1))) > 0);
    for (int i = 0; i <= slack; ++i) {
        u = u / T(2);
    }
    CHECK(graze::sign(T(T(1) + u - T(1))) == 0);
}

// |√x √x - x| <= 3u x + O(u²) for roots and products with a relative error of at most u.
template <class T>
void check_root(double unit) {
    for (int x = 2; x < 200; ++x) {
        const T root = graze::square_root(T(x));
        CHECK(is_within(T(root * root - T(x)), (3 * unit + 0x1p-20 * unit) * x));
    }
}

} // namespace adapter
