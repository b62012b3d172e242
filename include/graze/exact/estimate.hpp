// A wide integer as a double, an exponent and a running error, for formulas whose exact value is expensive and whose
// sign is usually clear.
#pragma once

#include <graze/exact/approximate.hpp>

namespace graze::inline v0_1::detail {

// |exact - value · 2^exponent| <= error · 2^exponent in any rounding mode. |value| <= 2 and error <= 2^101; neither
// becomes infinite. A number type with the sums and products that the formulas need.
struct estimate {
    double value = 0;
    double error = 0;
    int exponent = 0;

    constexpr estimate() = default;
    constexpr explicit estimate(int one_or_zero) : value(one_or_zero) {}
    constexpr estimate(double v, double e, int power) : value(v), error(e), exponent(power) {}
};

[[nodiscard]] constexpr double magnitude(double x) noexcept { return x < 0 ? -x : x; }

// The same number with its value in [1, 2), or its error if that is far greater, so that products of any number of
// factors stay in range. Before, every part that is not zero is above 2^-1000.
[[nodiscard]] constexpr estimate normalised(const estimate& x) noexcept {
    const double leading = magnitude(x.value) < x.error * 0x1p-100 ? x.error : x.value;
    const int power = static_cast<int>(std::bit_cast<std::uint64_t>(leading) >> 52 & 0x7ff) - 1023;
    if (power < -1000) {
        return x;
    }
    const double scale = power_of_two(-power);
    return {x.value * scale, x.error * scale, x.exponent + power};
}

// x at a larger exponent. The bits shifted out become part of the error.
[[nodiscard]] constexpr estimate at_exponent(const estimate& x, int exponent) noexcept {
    const int down = exponent - x.exponent;
    if (down > 400) {
        return {0, (magnitude(x.value) + x.error) * 0x1p-400, exponent};
    }
    const double scale = power_of_two(-down);
    return {x.value * scale, x.error * scale, exponent};
}

template <class I>
[[nodiscard]] constexpr estimate estimate_of(const I& x) noexcept {
    const scaled_double s = approximate(x);
    return normalised({s.significand, magnitude(s.significand) * 0x1p-49, s.exponent});
}

[[nodiscard]] constexpr estimate operator-(const estimate& x) noexcept { return {-x.value, x.error, x.exponent}; }

[[nodiscard, gnu::noinline]] constexpr estimate operator*(const estimate& x, const estimate& y) noexcept {
    const double value = x.value * y.value;
    const double error =
        magnitude(x.value) * y.error + magnitude(y.value) * x.error + x.error * y.error + magnitude(value) * 0x1p-51;
    return normalised({value, error * (1 + 0x1p-48), x.exponent + y.exponent});
}

[[nodiscard]] constexpr bool is_zero(const estimate& x) noexcept { return x.value == 0 && x.error == 0; }

[[nodiscard, gnu::noinline]] constexpr estimate operator+(const estimate& x, const estimate& y) noexcept {
    if (is_zero(x) || is_zero(y)) { // the exponent of a zero means nothing
        return is_zero(x) ? y : x;
    }
    const int exponent = x.exponent > y.exponent ? x.exponent : y.exponent;
    const estimate a = at_exponent(x, exponent);
    const estimate b = at_exponent(y, exponent);
    const double error = a.error + b.error + (magnitude(a.value) + magnitude(b.value)) * 0x1p-51;
    return normalised({a.value + b.value, error * (1 + 0x1p-48), exponent});
}
[[nodiscard]] constexpr estimate operator-(const estimate& x, const estimate& y) noexcept { return x + -y; }

// Whether the sign of the estimate is certainly that of the exact value.
[[nodiscard]] constexpr bool is_certain(const estimate& x) noexcept { return magnitude(x.value) > x.error; }

} // namespace graze::inline v0_1::detail

namespace graze::inline v0_1 {

template <>
struct number_traits<detail::estimate> {
    static constexpr const char* name = "estimate";
    static constexpr bool is_exact = false;
    static constexpr int digits = 49;
};

} // namespace graze::inline v0_1
