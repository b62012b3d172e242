// Rational numbers, with the roots of those that are squares: head-on collisions stay rational.
#pragma once

#include <graze/number/traits.hpp>

#include <gmpxx.h>

#include <compare>
#include <stdexcept>
#include <utility>

class fraction {
  public:
    fraction(int x = 0) : value_(x) {}
    explicit fraction(mpq_class x) : value_(std::move(x)) {}

    [[nodiscard]] const mpq_class& value() const { return value_; }
    explicit operator double() const { return value_.get_d(); }
    fraction operator-() const { return fraction(mpq_class(-value_)); }
    friend fraction operator+(const fraction& x, const fraction& y) { return fraction(mpq_class(x.value_ + y.value_)); }
    friend fraction operator-(const fraction& x, const fraction& y) { return fraction(mpq_class(x.value_ - y.value_)); }
    friend fraction operator*(const fraction& x, const fraction& y) { return fraction(mpq_class(x.value_ * y.value_)); }
    friend fraction operator/(const fraction& x, const fraction& y) { return fraction(mpq_class(x.value_ / y.value_)); }
    friend bool operator==(const fraction& x, const fraction& y) { return x.value_ == y.value_; }
    friend std::strong_ordering operator<=>(const fraction& x, const fraction& y) {
        return cmp(x.value_, y.value_) <=> 0;
    }

  private:
    mpq_class value_;
};

template <>
struct graze::number_traits<fraction> {
    static constexpr const char* name = "fraction";
    static constexpr bool is_exact = true;
    static constexpr bool is_integer = false;
    static constexpr int digits = 0;

    static fraction sqrt(const fraction& x) {
        const mpz_class &top = x.value().get_num(), &bottom = x.value().get_den();
        if (mpz_perfect_square_p(top.get_mpz_t()) == 0 || mpz_perfect_square_p(bottom.get_mpz_t()) == 0) {
            throw std::domain_error("not the square of a fraction");
        }
        return fraction(mpq_class(::sqrt(top), ::sqrt(bottom)));
    }
};
