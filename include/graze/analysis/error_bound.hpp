// The rounding error of a formula, bounded by the compiler from the formula itself.
#pragma once

#include <graze/linear/vec.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>

namespace graze {

// A number type that speaks of what is computed in floating point. Of a computed value ẑ that stands for an exact one
// z:
//   |ẑ| <= magnitude · S   and   |ẑ - z| <= error · u · S,   with S = Π scale_k^degree_k
// for any scales (a length, a speed, ...) that bound the inputs. The rounding model is |fl(z) - z| <= u |z|: with u =
// 2^-52 it holds for doubles in every rounding mode; a fused multiply-add, a register of more precision or another
// order of a sum leaves roundings out or keeps within the same count, so that the bounds hold with them too. Under- and
// overflow are excluded by the caller.
//
// A vec<N, error_bound> is bounded as a whole: each component carries the bound of the Euclidean norm of the vector and
// of its error vector. Inner products are then bounded by Cauchy and Schwarz, with no factor N.
//
// Adding values of different degrees throws, which in a constant expression does not compile.
struct error_bound {
    static constexpr std::size_t scales = 3; // length, velocity, normal
    using degrees = std::array<int, scales>;

    double magnitude = 0;
    double error = 0;
    degrees degree{};

    constexpr error_bound() = default;
    constexpr error_bound(double magnitude_, double error_, degrees degree_)
        : magnitude(magnitude_), error(error_), degree(degree_) {}
    // A small constant; only 0 goes with every degree, and no formula here adds another.
    constexpr explicit error_bound(int value) : magnitude(value < 0 ? -value : value) {}

    // u of doubles in any rounding mode.
    static constexpr double unit = 0x1p-52;
    // An input of the given degree that is exact, and one that was rounded once (a difference or sum of inputs).
    [[nodiscard]] static constexpr error_bound exact_input(degrees d) { return {1, 0, d}; }
    [[nodiscard]] static constexpr error_bound rounded_input(degrees d) { return {1, 1 / (1 - unit), d}; }
};

namespace detail {

// After `count` roundings in a row of something of at most `magnitude`: (1+u)^count - 1 <= count u / (1 - count u).
[[nodiscard]] constexpr error_bound rounded(double magnitude, double propagated, double spread, int count,
                                            error_bound::degrees degree) {
    const double n = static_cast<double>(count);
    const double growth = n / (1 - n * error_bound::unit);
    const double rounding = growth * spread;
    return {magnitude + error_bound::unit * rounding, propagated + rounding, degree};
}

// The error that a product takes over from its factors: x̂ŷ - xy with x = x̂ - δ, y = ŷ - ε.
[[nodiscard]] constexpr double inherited(const error_bound& x, const error_bound& y) {
    return x.magnitude * y.error + y.magnitude * x.error + error_bound::unit * x.error * y.error;
}

[[nodiscard]] constexpr error_bound::degrees sum_of(const error_bound::degrees& x, const error_bound::degrees& y) {
    return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}

} // namespace detail

[[nodiscard]] constexpr error_bound operator-(const error_bound& x) { return x; }

[[nodiscard]] constexpr error_bound operator+(const error_bound& x, const error_bound& y) {
    if (x.degree != y.degree) {
        throw std::logic_error("error_bound: a sum of quantities of different dimensions");
    }
    const double magnitude = x.magnitude + y.magnitude;
    return detail::rounded(magnitude, x.error + y.error, magnitude, 1, x.degree);
}
[[nodiscard]] constexpr error_bound operator-(const error_bound& x, const error_bound& y) { return x + y; }

[[nodiscard]] constexpr error_bound operator*(const error_bound& x, const error_bound& y) {
    const double magnitude = x.magnitude * y.magnitude;
    return detail::rounded(magnitude, detail::inherited(x, y), magnitude, 1, detail::sum_of(x.degree, y.degree));
}

template <>
struct number_traits<error_bound> {
    static constexpr const char* name = "error_bound";
    static constexpr bool is_exact = false;
    static constexpr int digits = 53;

    static constexpr int sign(const error_bound& x) { return x.magnitude != 0 ? 1 : 0; }
    static constexpr error_bound twice(const error_bound& x) { return {2 * x.magnitude, 2 * x.error, x.degree}; }

    // N products, each rounded and taking part in at most N - 1 sums: N roundings of Σ|x_i||y_i| <= |x||y|.
    template <int N>
    static constexpr error_bound dot(const vec<N, error_bound>& x, const vec<N, error_bound>& y) {
        const double magnitude = x[0].magnitude * y[0].magnitude;
        return detail::rounded(magnitude, detail::inherited(x[0], y[0]), magnitude, N,
                               detail::sum_of(x[0].degree, y[0].degree));
    }
    template <int N>
    static constexpr error_bound squared_norm(const vec<N, error_bound>& x) {
        return dot(x, x);
    }

    // A component x_j y_k - x_k y_j takes two roundings of |x_j||y_k| + |x_k||y_j|. In the plane that is at most |x||y|
    // (Cauchy, Schwarz); in space the vector of these sums has norm at most √2 |x||y|, since (p + q)² <= 2p² + 2q².
    static constexpr vec<3, error_bound> cross(const vec<3, error_bound>& x, const vec<3, error_bound>& y) {
        const double magnitude = x[0].magnitude * y[0].magnitude;
        const error_bound b = detail::rounded(magnitude, detail::inherited(x[0], y[0]), 1.4142136 * magnitude, 2,
                                              detail::sum_of(x[0].degree, y[0].degree));
        return {{b, b, b}};
    }
    static constexpr error_bound cross(const vec<2, error_bound>& x, const vec<2, error_bound>& y) {
        const double magnitude = x[0].magnitude * y[0].magnitude;
        return detail::rounded(magnitude, detail::inherited(x[0], y[0]), magnitude, 2,
                               detail::sum_of(x[0].degree, y[0].degree));
    }
};

// A vector whose norm and whose error's norm are bounded as b says.
template <int N>
[[nodiscard]] constexpr vec<N, error_bound> bounded_vector(const error_bound& b) {
    return make_vec<N>([&](int) { return b; });
}

// The factor that covers the compiler's own roundings of magnitude and error: below 2^12 operations of 2^-53 each.
inline constexpr double error_bound_slack = 1 + 0x1p-40;

} // namespace graze
