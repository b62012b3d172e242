// GMP's mpq_class as a number (link gmp). mpq_class itself is not a number: its sums are expressions that refer to
// their operands and dangle in an `auto`. (For Boost's mpq_rational, another wrapper of mpq_t, use
// number/adapter/boost.hpp.)
#pragma once

#include <graze/number/traits.hpp>

#include <compare>
#include <gmpxx.h>
#include <utility>

namespace graze::inline v0_1 {

// An exact rational whose operators return values. GMP raises SIGFPE on a division by zero.
class gmp_rational {
  public:
    gmp_rational() = default;
    gmp_rational(int x) : value_(x) {}
    explicit gmp_rational(double x) : value_(x) {} // exactly; x is finite
    explicit gmp_rational(mpq_class x) : value_(std::move(x)) {}

    [[nodiscard]] const mpq_class& value() const noexcept { return value_; }

    [[nodiscard]] gmp_rational operator-() const { return gmp_rational(mpq_class(-value_)); }
    [[nodiscard]] friend gmp_rational operator+(const gmp_rational& x, const gmp_rational& y) {
        return gmp_rational(mpq_class(x.value_ + y.value_));
    }
    [[nodiscard]] friend gmp_rational operator-(const gmp_rational& x, const gmp_rational& y) {
        return gmp_rational(mpq_class(x.value_ - y.value_));
    }
    [[nodiscard]] friend gmp_rational operator*(const gmp_rational& x, const gmp_rational& y) {
        return gmp_rational(mpq_class(x.value_ * y.value_));
    }
    [[nodiscard]] friend gmp_rational operator/(const gmp_rational& x, const gmp_rational& y) {
        return gmp_rational(mpq_class(x.value_ / y.value_));
    }
    gmp_rational& operator+=(const gmp_rational& x) {
        value_ += x.value_;
        return *this;
    }
    gmp_rational& operator-=(const gmp_rational& x) {
        value_ -= x.value_;
        return *this;
    }
    gmp_rational& operator*=(const gmp_rational& x) {
        value_ *= x.value_;
        return *this;
    }
    gmp_rational& operator/=(const gmp_rational& x) {
        value_ /= x.value_;
        return *this;
    }

    [[nodiscard]] friend bool operator==(const gmp_rational& x, const gmp_rational& y) { return x.value_ == y.value_; }
    [[nodiscard]] friend std::strong_ordering operator<=>(const gmp_rational& x, const gmp_rational& y) {
        return cmp(x.value_, y.value_) <=> 0;
    }

  private:
    mpq_class value_;
};

template <>
struct number_traits<gmp_rational> {
    static constexpr const char* name = "mpq_class";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static int sign(const gmp_rational& x) { return sgn(x.value()); }
};

} // namespace graze::inline v0_1
