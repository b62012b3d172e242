// What a number is.
//
// Every formula of graze is a template over its number type and says `auto` for what it computes. So a type may widen
// (an integer<62> times an integer<62> is an integer<124>), but its sums and products must be values. An expression
// template is not a number: its operands may no longer exist when it is evaluated.
#pragma once

#include <concepts>
#include <type_traits>

namespace graze::inline v0_1 {

// Specialise for a number type T:
//   static constexpr const char* name;   its name in tables and messages
//   static constexpr bool is_exact;      sums, products and negations (and quotients, if it has them) never round
//   static constexpr int digits;         bits of the significand; 0 if is_exact or if there is no such number
// and, where it applies:
//   static constexpr bool is_integer;    true for a type whose operator/ truncates: it is no field_number
//   static T sqrt(const T&);             the type has a square root of its own
//   static T fma(const T&, const T&, const T&);   x*y + z, rounded once
template <class T>
struct number_traits;

// A type that number_traits describes: not a reference, not an expression template.
template <class T>
concept number_value = requires {
    { number_traits<std::remove_cvref_t<T>>::is_exact } -> std::convertible_to<bool>;
    { number_traits<std::remove_cvref_t<T>>::digits } -> std::convertible_to<int>;
    number_traits<std::remove_cvref_t<T>>::name;
};

template <class T>
concept sum_is_a_value = requires(const T& x, const T& y) {
    { x + y } -> number_value;
    { x - y } -> number_value;
};

template <class T>
concept product_is_a_value = requires(const T& x, const T& y) {
    { x* y } -> number_value;
};

template <class T>
concept negation_is_a_value = requires(const T& x) {
    { -x } -> number_value;
};

// A commutative ring whose elements can be made from an int and whose sums, products and negations are values.
template <class T>
concept number = number_value<T> && std::copy_constructible<T> && std::constructible_from<T, int> &&
    sum_is_a_value<T> && product_is_a_value<T> && negation_is_a_value<T>;

template <class T>
concept exact_number = number<T> && number_traits<T>::is_exact;

template <class T>
concept integer_value = requires {
    requires number_traits<T>::is_integer;
};

// A number that also divides, other than by truncation.
template <class T>
concept field_number = number<T> && !integer_value<T> && requires(const T& x, const T& y) {
    { x / y } -> number_value;
};

template <class T>
concept has_sqrt = number<T> && requires(const T& x) {
    { number_traits<T>::sqrt(x) } -> number_value;
};

template <class T>
concept has_fma = number<T> && requires(const T& x) {
    { number_traits<T>::fma(x, x, x) } -> number_value;
};

// The sign of x: -1, 0 or +1. Exact in every type whose comparison with zero is exact. A type's traits may define their
// own.
template <number T>
[[nodiscard]] constexpr int sign(const T& x) {
    if constexpr (requires { number_traits<T>::sign(x); }) {
        return number_traits<T>::sign(x);
    } else {
        const T zero(0);
        return x < zero ? -1 : (zero < x ? 1 : 0);
    }
}

// 2x. Exact in every binary type. A type for which it costs less than a sum may define its own in its traits.
template <number T>
[[nodiscard]] constexpr auto twice(const T& x) {
    if constexpr (requires { number_traits<T>::twice(x); }) {
        return number_traits<T>::twice(x);
    } else {
        return x + x;
    }
}

// The larger and the smaller of x and y. A type whose comparison is not a bool defines its own in its traits.
template <class T>
[[nodiscard]] constexpr T larger(const T& x, const T& y) {
    if constexpr (requires { number_traits<T>::larger(x, y); }) {
        return number_traits<T>::larger(x, y);
    } else {
        return x < y ? y : x;
    }
}
template <class T>
[[nodiscard]] constexpr T smaller(const T& x, const T& y) {
    if constexpr (requires { number_traits<T>::smaller(x, y); }) {
        return number_traits<T>::smaller(x, y);
    } else {
        return y < x ? y : x;
    }
}

// The square root by the type's own routine, with that routine's error.
template <has_sqrt T>
[[nodiscard]] constexpr T square_root(const T& x) {
    return number_traits<T>::sqrt(x);
}

} // namespace graze::inline v0_1
