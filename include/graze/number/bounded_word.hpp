// A double word with a running error: formulas that run in it bound their own error.
#pragma once

#include <graze/machine/fence.hpp>
#include <graze/number/double_word.hpp>

namespace graze::inline v0_1::detail {

// |exact - value| <= error. The bounds of double_word's operations (3u² + 13u³ < 2^-103, 7u² < 2^-102, 15u² + 56u³ <
// 2^-101, 25/8 u² < 2^-103) leave room for the roundings of the error itself, which are below 2^-50 of it. Underflow
// loses less than 2^-1040 in a product, and less than 2^-600 in a quotient by at least 2^-400. An error of 0 stays 0 in
// products with an exact 0, in sums and products of two doubles, and in quotients and roots that
// are doubles.
class bounded_word {
  public:
    constexpr bounded_word() = default;
    explicit(false) bounded_word(int x) noexcept : value_(x) {}
    explicit bounded_word(double x) noexcept : value_(x) {}
    // A value without a limit on its error: it may stand for any number.
    [[nodiscard]] static bounded_word unknown() noexcept { return {double_word(1), hidden_infinity()}; }

    [[nodiscard]] const double_word& value() const noexcept { return value_; }
    [[nodiscard]] double error() const noexcept { return error_; }
    [[nodiscard]] bool has_certain_sign() const noexcept { return size() > 2 * error_; }
    [[nodiscard]] bool is_zero() const noexcept { return value_.high() == 0 && error_ == 0; }

    [[nodiscard]] friend bounded_word operator-(const bounded_word& x) noexcept { return {-x.value_, x.error_}; }
    [[nodiscard]] friend bounded_word operator+(const bounded_word& x, const bounded_word& y) noexcept {
        if (x.is_double() && y.is_double()) {
            return {double_word::sum(x.value_.high(), y.value_.high()), 0.0};
        }
        const bounded_word sum{x.value_ + y.value_, slack * (x.error_ + y.error_)};
        return {sum.value_, sum.error_ + 0x1p-103 * sum.size()};
    }
    [[nodiscard]] friend bounded_word operator-(const bounded_word& x, const bounded_word& y) noexcept {
        return x + -y;
    }
    [[nodiscard]] friend bounded_word operator*(const bounded_word& x, const bounded_word& y) noexcept {
        if (x.is_zero() || y.is_zero()) {
            return {};
        }
        if (x.is_double() && y.is_double()) {
            const bounded_word exact{double_word::product(x.value_.high(), y.value_.high()), 0.0};
            return {exact.value_, exact.size() > 0x1p-900 ? 0.0 : 0x1p-1040};
        }
        const bounded_word product{x.value_ * y.value_,
                                   slack * (x.size() * y.error_ + (y.size() + y.error_) * x.error_)};
        return {product.value_, product.error_ + (0x1p-102 * product.size() + 0x1p-1040)};
    }
    // Unknown if y is not well apart from 0. |X/Y - x/y| <= (error of x + |x/y| error of y)/(|y| - error of y).
    [[nodiscard]] friend bounded_word operator/(const bounded_word& x, const bounded_word& y) noexcept {
        if (!(y.has_certain_sign() && y.size() > 0x1p-400)) {
            return unknown();
        }
        if (x.is_zero()) {
            return {};
        }
        const bounded_word quotient{x.value_ / y.value_, 0.0};
        if (x.is_double() && y.is_double() && quotient.is_double() && quotient.size() > 0x1p-500) {
            return quotient; // any remainder would be in the low part
        }
        const double moved = slack * (x.error_ + quotient.size() * y.error_) / (y.size() - y.error_);
        return {quotient.value_, slack * moved + (0x1p-101 * quotient.size() + 0x1p-600)};
    }
    // Unknown if x is not well above 0. |√X - √x| <= (error of x)/√x.
    [[nodiscard]] friend bounded_word sqrt(const bounded_word& x) noexcept {
        if (!(x.value_.high() > 0x1p-400 && x.has_certain_sign())) {
            return unknown();
        }
        const bounded_word root{sqrt(x.value_), 0.0};
        if (x.is_double() && root.is_double()) {
            return root;
        }
        return {root.value_, slack * x.error_ / root.size() + (0x1p-103 * root.size() + 0x1p-600)};
    }

  private:
    static constexpr double slack = 1 + 0x1p-40;

    bounded_word(const double_word& value, double error) noexcept : value_(value), error_(error) {}
    [[nodiscard]] bool is_double() const noexcept { return value_.low() == 0 && error_ == 0; }
    [[nodiscard]] double size() const noexcept { return value_.high() < 0 ? -value_.high() : value_.high(); }

    double_word value_;
    double error_ = 0;
};

[[nodiscard]] bounded_word sqrt(const bounded_word& x) noexcept;

} // namespace graze::inline v0_1::detail

template <>
struct graze::number_traits<graze::detail::bounded_word> {
    static constexpr const char* name = "bounded_word";
    static constexpr bool is_exact = false;
    static constexpr int digits = 101;
    static int sign(const detail::bounded_word& x) noexcept { return graze::sign(x.value()); }
    static detail::bounded_word sqrt(const detail::bounded_word& x) noexcept { return graze::detail::sqrt(x); }
};
