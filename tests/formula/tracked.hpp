// A number type that computes in T with a running error: every operation updates a bound on the distance from the exact
// value (running error analysis, Wilkinson; Higham, Accuracy and Stability of Numerical Algorithms, 3.3). The formulas
// run in it unchanged, so the bound on each result is derived from the problem instead of chosen.
#pragma once

#include <graze/number/traits.hpp>

#include <cmath>
#include <limits>

namespace inexact {

// The rounding error of an operation in T with the result z: unit·|z|; for a type whose sums may cancel badly, `sums`
// takes |x| + |y| instead of |z|. The default is half a unit in the last place, for a T that rounds to nearest.
template <class T>
struct rounding {
    static double unit() { return std::ldexp(1.0, -graze::number_traits<T>::digits); }
    static constexpr bool sums_by_operands = false;
};

// Bounds are computed in double. Each operation is enlarged by more than its own rounding.
inline double up(double x) { return x * (1 + 0x1p-40); }

template <class T>
double magnitude(const T& x) {
    return up(std::abs(static_cast<double>(x)));
}

template <class T>
struct tracked {
    T value;
    double error; // |value - exact| <= error

    tracked() : value(0), error(0) {}
    tracked(int x) : value(static_cast<T>(x)), error(0) {}
    explicit tracked(T x) : value(std::move(x)), error(0) {}
    tracked(T x, double bound) : value(std::move(x)), error(bound) {}

    static tracked rounded(T x, double inherited, double size) {
        const double bound = up(up(inherited) + up(rounding<T>::unit() * size));
        return tracked(std::move(x), bound);
    }
    static double size_of_sum(const T& z, const tracked& x, const tracked& y) {
        return rounding<T>::sums_by_operands ? magnitude(x.value) + magnitude(y.value) : magnitude(z);
    }

    tracked operator-() const { return {T(-value), error}; }
    friend tracked operator+(const tracked& x, const tracked& y) {
        T z = x.value + y.value;
        const double size = size_of_sum(z, x, y);
        return rounded(std::move(z), x.error + y.error, size);
    }
    friend tracked operator-(const tracked& x, const tracked& y) {
        T z = x.value - y.value;
        const double size = size_of_sum(z, x, y);
        return rounded(std::move(z), x.error + y.error, size);
    }
    static double error_of_product(const tracked& x, const tracked& y) {
        return up(magnitude(x.value) * y.error) + up(magnitude(y.value) * x.error) + up(x.error * y.error);
    }
    friend tracked operator*(const tracked& x, const tracked& y) {
        T z = x.value * y.value;
        const double size = magnitude(z);
        return rounded(std::move(z), error_of_product(x, y), size);
    }
    friend tracked operator/(const tracked& x, const tracked& y) {
        T z = x.value / y.value;
        const double size = magnitude(z);
        const double divisor = magnitude(y.value) * (1 - 0x1p-38) - y.error;
        const double inherited =
            divisor > 0 ? up(up(x.error + up(size * y.error)) / divisor) : std::numeric_limits<double>::infinity();
        return rounded(std::move(z), inherited, size);
    }
    friend bool operator==(const tracked& x, const tracked& y) { return x.value == y.value; }
    friend bool operator<(const tracked& x, const tracked& y) { return x.value < y.value; }
};

// Set if a sign was taken that the error leaves open. Only then may a decision be wrong.
inline bool sign_was_uncertain = false;

} // namespace inexact

namespace graze {

template <class T>
struct number_traits<inexact::tracked<T>> {
    using number = inexact::tracked<T>;
    static constexpr const char* name = "tracked";
    static constexpr bool is_exact = false;
    static constexpr int digits = number_traits<T>::digits;
    static int sign(const number& x) {
        if (x.error > 0 && inexact::magnitude(x.value) <= inexact::up(inexact::up(x.error))) {
            inexact::sign_was_uncertain = true;
        }
        return graze::sign(x.value);
    }
    // |√x - √y| is at most √|x - y| and |x - y|/√x.
    static number sqrt(const number& x) {
        T z = graze::square_root(x.value);
        const double size = inexact::magnitude(z);
        const double inherited =
            size > 0 ? std::fmin(std::sqrt(x.error), inexact::up(x.error / size)) : std::sqrt(x.error);
        return number::rounded(std::move(z), inexact::up(inherited), size);
    }
    static number fma(const number& x, const number& y, const number& z) requires(has_fma<T>) {
        T sum = number_traits<T>::fma(x.value, y.value, z.value);
        const double size = inexact::magnitude(sum);
        return number::rounded(std::move(sum), number::error_of_product(x, y) + z.error, size);
    }
};

} // namespace graze
