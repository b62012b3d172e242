// Passes on, exactly, the value that a number type computed.
#pragma once

#include "convert.hpp"
#include "solver.hpp"

#include <graze/number/sqrt_extension.hpp>

#include <utility>

namespace compare {

// A finite number of a binary type, split into digits by operations that are exact in the type.
template <class T>
[[nodiscard]] binary_number taken_apart(T x) {
    const T large = T(65536) * T(65536);
    const T small = T(1) / large;
    binary_number result;
    result.significand.negative = x < T(0);
    if (result.significand.negative) {
        x = -x;
    }
    result.exponent = 32;
    for (; x >= large; x = x * small) {
        result.exponent += 32;
    }
    for (; x > T(0) && x < T(1); x = x * large) {
        result.exponent -= 32;
    }
    while (x > T(0)) {
        const auto digit = static_cast<std::uint32_t>(x);
        result.significand.digits.push_back(digit);
        x = (x - T(digit)) * large;
        result.exponent -= 32;
    }
    return result;
}

// A type whose values are not binary floating-point numbers specialises this:
//   static void read(const T& x, const request& asked);   passes x on
//   static void settle(const T& x);   lazy types only: computes what printing x would need; this is timed
template <class T>
struct reader {
    static void read(const T& x, const request& asked) {
        if (x - x == T(0)) {
            asked.to.number(taken_apart<T>(x));
        } else {
            asked.to.not_finite();
        }
    }
};

// For an exact type: whether x is the true value. The type itself decides it.
template <class T>
[[nodiscard]] bool is_exactly_right(const T& x, const due_number& due) {
    return due.q.is_zero() && graze::sign(T(x - convert<T>(due.p))) == 0;
}
template <class T>
[[nodiscard]] bool is_exactly_right(const graze::sqrt_extension<T>& x, const due_number& due) {
    if (graze::sign(x.q()) == 0) {
        return is_exactly_right(x.p(), due);
    }
    const T q = convert<T>(due.q);
    return graze::sign(x.q()) == graze::sign(q) && graze::sign(T(x.p() - convert<T>(due.p))) == 0 &&
           graze::sign(T(x.q() * x.q() * x.d() - q * q * convert<T>(due.d))) == 0;
}

template <class T>
struct reader<graze::sqrt_extension<T>> {
    using real = graze::sqrt_extension<T>;
    static void read(const real& x, const request& asked) {
        if (is_exactly_right(x, asked.due)) {
            asked.to.exactly_right();
        } else {
            asked.to.surd(reader<T>::parts_of(x.p()), reader<T>::parts_of(x.q()), reader<T>::parts_of(x.d()));
        }
    }
    static void settle(const real& x) requires requires(const T& y) { reader<T>::settle(y); }
    {
        reader<T>::settle(x.p());
        reader<T>::settle(x.q());
        reader<T>::settle(x.d());
    }
};

// The base of readers of exact rational types. They provide
//   static fraction parts_of(const T& x)
template <class T>
struct exact_reader {
    static void read(const T& x, const request& asked) {
        if (is_exactly_right(x, asked.due)) {
            asked.to.exactly_right();
        } else {
            asked.to.surd(reader<T>::parts_of(x), fraction{{}, {false, {1}}}, fraction{{}, {false, {1}}});
        }
    }
};

} // namespace compare
