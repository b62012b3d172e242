// The rounding error of a formula with quotients and roots whose inputs are in known ranges.
#pragma once

#include <graze/number/floating.hpp>

#include <stdexcept>

namespace graze::inline v0_1 {

// For a computed value ẑ and the exact value z that it stands for: low <= z <= high and |ẑ - z| <= error·u, with u =
// 2^(1-Digits). Each component of a vector has a range of its own (error_bound bounds vectors as a whole). The rounding
// model is that of error_bound, |fl(z) - z| <= u|z| for sums, products, quotients, roots and fused multiply-adds, in
// any rounding mode, contracted or not, without under- and overflow. The bounds themselves are computed in doubles:
// allow for error_bound_slack.
template <int Digits = 53>
struct range_bound {
    double low = 0;
    double high = 0;
    double error = 0;

    static constexpr double unit = [] {
        double u = 2;
        for (int i = 0; i < Digits; ++i) {
            u /= 2;
        }
        return u;
    }();

    constexpr range_bound() = default;
    constexpr explicit range_bound(int value) : low(value), high(value) {}
    constexpr range_bound(double low_, double high_, double error_) : low(low_), high(high_), error(error_) {}

    // An input in [-1,1]: exact, or rounded once.
    [[nodiscard]] static constexpr range_bound exact_input() { return {-1, 1, 0}; }
    [[nodiscard]] static constexpr range_bound rounded_input() { return {-1 - 2 * unit, 1 + 2 * unit, 1 + 2 * unit}; }

    // The same value, in a range that the caller knows to be narrower.
    [[nodiscard]] constexpr range_bound within(double from, double to) const {
        return {from > low ? from : low, to < high ? to : high, error};
    }

    [[nodiscard]] constexpr double magnitude() const { return -low > high ? -low : high; }
    // The result of an operation: [from, to] is its exact range, `inherited` the error before it rounds.
    [[nodiscard]] static constexpr range_bound rounded(double from, double to, double inherited) {
        const range_bound exact{from, to, inherited};
        return {from, to, inherited + exact.magnitude() + unit * inherited};
    }

    [[nodiscard]] constexpr range_bound operator-() const { return {-high, -low, error}; }
    [[nodiscard]] friend constexpr range_bound operator+(const range_bound& x, const range_bound& y) {
        return rounded(x.low + y.low, x.high + y.high, x.error + y.error);
    }
    [[nodiscard]] friend constexpr range_bound operator-(const range_bound& x, const range_bound& y) { return x + -y; }
    [[nodiscard]] friend constexpr range_bound operator*(const range_bound& x, const range_bound& y) {
        const range_bound p = product(x, y);
        return rounded(p.low, p.high, p.error);
    }
    // x̂/ŷ - x/y = ((x̂ - x) - (x/y)(ŷ - y))/ŷ.
    [[nodiscard]] friend constexpr range_bound operator/(const range_bound& x, const range_bound& y) {
        const double least = (y.low > 0 ? y.low : -y.high) - unit * y.error; // the least |ŷ|
        if (!(least > 0)) {
            throw std::domain_error("range_bound: the divisor may be 0");
        }
        const range_bound inverse{1 / y.high, 1 / y.low, 0};
        const range_bound q = product(x, inverse);
        return rounded(q.low, q.high, (x.error + range_bound{q.low, q.high, 0}.magnitude() * y.error) / least);
    }
    // The product without its own rounding.
    [[nodiscard]] static constexpr range_bound product(const range_bound& x, const range_bound& y) {
        const double ends[4] = {x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high};
        range_bound p{ends[0], ends[0], x.magnitude() * y.error + y.magnitude() * x.error + unit * x.error * y.error};
        for (const double end : ends) {
            p.low = end < p.low ? end : p.low;
            p.high = end > p.high ? end : p.high;
        }
        return p;
    }
};

template <int Digits>
struct number_traits<range_bound<Digits>> {
    static constexpr const char* name = "range_bound";
    static constexpr bool is_exact = false;
    static constexpr int digits = Digits;
    using bound = range_bound<Digits>;

    // The sign of every computed value, which may be outside the range by its error.
    static constexpr int sign(const bound& x) {
        const double beside = bound::unit * x.error;
        if (x.low - beside > 0) {
            return 1;
        }
        if (x.high + beside < 0) {
            return -1;
        }
        if (x.low < 0 || x.high > 0 || x.error > 0) {
            throw std::domain_error("range_bound: a sign that is not known");
        }
        return 0;
    }
    static constexpr bound twice(const bound& x) { return {2 * x.low, 2 * x.high, 2 * x.error}; }
    // |√x̂ - √x| = |x̂ - x|/(√x̂ + √x).
    static constexpr bound sqrt(const bound& x) {
        const double least = x.low - bound::unit * x.error;
        if (!(least > 0)) {
            throw std::domain_error("range_bound: the root's argument may be 0");
        }
        const double root = detail::constant_sqrt(x.low);
        return bound::rounded(root, detail::constant_sqrt(x.high), x.error / (detail::constant_sqrt(least) + root));
    }
    static constexpr bound fma(const bound& x, const bound& y, const bound& z) {
        const bound p = bound::product(x, y);
        return bound::rounded(p.low + z.low, p.high + z.high, p.error + z.error);
    }
};

} // namespace graze::inline v0_1
