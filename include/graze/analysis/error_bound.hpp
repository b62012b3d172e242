// The rounding error of a formula, bounded by the compiler from the formula itself.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/machine/failure.hpp>

#include <array>
#include <cstddef>

namespace graze::inline v0_1 {

// A number type that describes values computed in floating point of Digits bits. For a computed value ẑ and the exact
// value z that it stands for:
//   |ẑ| <= magnitude · S   and   |ẑ - z| <= error · u · S,   with S = Π scale_k^degree_k
// for any scales (a length, a speed, ...) that bound the inputs. The rounding model is |fl(z) - z| <= u |z|. With u =
// 2^(1-Digits) it holds in every rounding mode. A fused multiply-add, a register of more precision or another order of
// a sum omits roundings or stays within the same count, so the bounds hold with them too. The caller excludes under-
// and overflow.
//
// A vec<N, error_bound> is bounded as a whole: each component carries the bounds on the Euclidean norms of the vector
// and of its error vector. Inner products are then bounded by Cauchy and Schwarz, with no factor N.
//
// Adding values of different degrees throws; in a constant expression it does not compile.
template <int Digits>
struct basic_error_bound {
    static constexpr std::size_t scales = 3; // length, velocity, normal
    using degrees = std::array<int, scales>;

    double magnitude = 0;
    double error = 0;
    degrees degree{};

    constexpr basic_error_bound() = default;
    constexpr basic_error_bound(double magnitude_, double error_, degrees degree_)
        : magnitude(magnitude_), error(error_), degree(degree_) {}
    // A small constant, of degree 0. Only 0 may be added to values of every degree; no formula here adds another
    // constant.
    constexpr explicit basic_error_bound(int value) : magnitude(value < 0 ? -value : value) {}

    // The u that holds in any rounding mode.
    static constexpr double unit = [] {
        double u = 2;
        for (int i = 0; i < Digits; ++i) {
            u /= 2;
        }
        return u;
    }();
    // The factor that covers fewer than 2^12 roundings beside a bound: the compiler's own, of magnitude and error, and
    // those of the scales.
    static constexpr double slack = 1 + 0x1p12 * unit;
    // An input of the given degree that is exact, and one that was rounded once (a difference or sum of inputs).
    [[nodiscard]] static constexpr basic_error_bound exact_input(degrees d) { return {1, 0, d}; }
    [[nodiscard]] static constexpr basic_error_bound rounded_input(degrees d) { return {1, 1 / (1 - unit), d}; }
};

// For doubles: the filters' bounds.
using error_bound = basic_error_bound<53>;

namespace detail {

// After `count` roundings in a row of a value of at most `magnitude`: (1+u)^count - 1 <= count u / (1 - count u).
template <int Digits = 53>
[[nodiscard]] constexpr basic_error_bound<Digits> rounded(double magnitude, double propagated, double spread, int count,
                                                          error_bound::degrees degree) {
    constexpr double unit = basic_error_bound<Digits>::unit;
    const double n = static_cast<double>(count);
    const double growth = n / (1 - n * unit);
    const double rounding = growth * spread;
    return {magnitude + unit * rounding, propagated + rounding, degree};
}

// The error that a product inherits from its factors: x̂ŷ - xy with x = x̂ - δ, y = ŷ - ε.
template <int Digits>
[[nodiscard]] constexpr double inherited(const basic_error_bound<Digits>& x, const basic_error_bound<Digits>& y) {
    return x.magnitude * y.error + y.magnitude * x.error + basic_error_bound<Digits>::unit * x.error * y.error;
}

[[nodiscard]] constexpr error_bound::degrees sum_of(const error_bound::degrees& x, const error_bound::degrees& y) {
    return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}
template <int Digits>
constexpr void check_degrees(const basic_error_bound<Digits>& x, const basic_error_bound<Digits>& y) {
    if (x.degree != y.degree) {
        detail::fail<std::logic_error>("error_bound: a sum of quantities of different dimensions");
    }
}

} // namespace detail

template <int Digits>
[[nodiscard]] constexpr basic_error_bound<Digits> operator-(const basic_error_bound<Digits>& x) {
    return x;
}

template <int Digits>
[[nodiscard]] constexpr basic_error_bound<Digits> operator+(const basic_error_bound<Digits>& x,
                                                            const basic_error_bound<Digits>& y) {
    detail::check_degrees(x, y);
    const double magnitude = x.magnitude + y.magnitude;
    return detail::rounded<Digits>(magnitude, x.error + y.error, magnitude, 1, x.degree);
}
template <int Digits>
[[nodiscard]] constexpr basic_error_bound<Digits> operator-(const basic_error_bound<Digits>& x,
                                                            const basic_error_bound<Digits>& y) {
    return x + y;
}

template <int Digits>
[[nodiscard]] constexpr basic_error_bound<Digits> operator*(const basic_error_bound<Digits>& x,
                                                            const basic_error_bound<Digits>& y) {
    const double magnitude = x.magnitude * y.magnitude;
    return detail::rounded<Digits>(magnitude, detail::inherited(x, y), magnitude, 1,
                                   detail::sum_of(x.degree, y.degree));
}

template <int Digits>
struct number_traits<basic_error_bound<Digits>> {
    static constexpr const char* name = "error_bound";
    static constexpr bool is_exact = false;
    static constexpr int digits = Digits;
    using bound = basic_error_bound<Digits>;

    static constexpr int sign(const bound& x) { return x.magnitude != 0 ? 1 : 0; }
    static constexpr bound twice(const bound& x) { return {2 * x.magnitude, 2 * x.error, x.degree}; }

    // A product and a sum, rounded once at the end.
    static constexpr bound fma(const bound& x, const bound& y, const bound& z) {
        const bound product{x.magnitude * y.magnitude, detail::inherited(x, y), detail::sum_of(x.degree, y.degree)};
        detail::check_degrees(product, z);
        const double magnitude = product.magnitude + z.magnitude;
        return detail::rounded<Digits>(magnitude, product.error + z.error, magnitude, 1, z.degree);
    }

    // N products, each rounded and taking part in at most N - 1 sums: N roundings of Σ|x_i||y_i| <= |x||y|.
    template <int N>
    static constexpr bound dot(const vec<N, bound>& x, const vec<N, bound>& y) {
        return product_of_norms(x, y, 1, N);
    }
    template <int N>
    static constexpr bound squared_norm(const vec<N, bound>& x) {
        return dot(x, x);
    }

    // A component x_j y_k - x_k y_j takes two roundings of |x_j||y_k| + |x_k||y_j|. In the plane that is at most |x||y|
    // (Cauchy, Schwarz); in space the vector of these sums has norm at most √2 |x||y|, since (p + q)² <= 2p² + 2q².
    static constexpr vec<3, bound> cross(const vec<3, bound>& x, const vec<3, bound>& y) {
        const bound b = product_of_norms(x, y, 1.4142136, 2);
        return {{b, b, b}};
    }
    static constexpr bound cross(const vec<2, bound>& x, const vec<2, bound>& y) {
        return product_of_norms(x, y, 1, 2);
    }

  private:
    // A value of at most |x||y|, after `count` roundings of at most `spread` times that.
    template <int N>
    static constexpr bound product_of_norms(const vec<N, bound>& x, const vec<N, bound>& y, double spread, int count) {
        const double magnitude = x[0].magnitude * y[0].magnitude;
        return detail::rounded<Digits>(magnitude, detail::inherited(x[0], y[0]), spread * magnitude, count,
                                       detail::sum_of(x[0].degree, y[0].degree));
    }
};

// A vector whose norm and whose error's norm have the bounds of b.
template <int N, int Digits>
[[nodiscard]] constexpr vec<N, basic_error_bound<Digits>> bounded_vector(const basic_error_bound<Digits>& b) {
    return make_vec<N>([&](int) { return b; });
}

// The factor that covers the compiler's own roundings of magnitude and error: below 2^12 operations of 2^-53 each.
inline constexpr double error_bound_slack = 1 + 0x1p-40;

} // namespace graze::inline v0_1
