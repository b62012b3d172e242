// Rational numbers, with the roots of those that are squares: head-on collisions stay rational.
#pragma once

#include <graze/number/traits.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <compare>
#include <stdexcept>
#include <utility>

class fraction {
  public:
    using value_type =
        boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

    fraction(int x = 0) : value_(x) {}
    explicit fraction(value_type x) : value_(std::move(x)) {}

    [[nodiscard]] const value_type& value() const { return value_; }
    explicit operator double() const { return value_.convert_to<double>(); }
    fraction operator-() const { return fraction(value_type(-value_)); }
    friend fraction operator+(const fraction& x, const fraction& y) {
        return fraction(value_type(x.value_ + y.value_));
    }
    friend fraction operator-(const fraction& x, const fraction& y) {
        return fraction(value_type(x.value_ - y.value_));
    }
    friend fraction operator*(const fraction& x, const fraction& y) {
        return fraction(value_type(x.value_ * y.value_));
    }
    friend fraction operator/(const fraction& x, const fraction& y) {
        return fraction(value_type(x.value_ / y.value_));
    }
    friend bool operator==(const fraction& x, const fraction& y) { return x.value_ == y.value_; }
    friend std::strong_ordering operator<=>(const fraction& x, const fraction& y) {
        const int order = x.value_.compare(y.value_);
        return order < 0   ? std::strong_ordering::less
               : order > 0 ? std::strong_ordering::greater
                           : std::strong_ordering::equal;
    }

  private:
    value_type value_;
};

template <>
struct graze::number_traits<fraction> {
    static constexpr const char* name = "fraction";
    static constexpr bool is_exact = true;
    static constexpr bool is_integer = false;
    static constexpr int digits = 0;

    static fraction sqrt(const fraction& x) {
        const auto top = numerator(x.value()), bottom = denominator(x.value());
        const decltype(top) root_of_top = boost::multiprecision::sqrt(top);
        const decltype(top) root_of_bottom = boost::multiprecision::sqrt(bottom);
        if (root_of_top * root_of_top != top || root_of_bottom * root_of_bottom != bottom) {
            throw std::domain_error("not the square of a fraction");
        }
        return fraction(fraction::value_type(root_of_top, root_of_bottom));
    }
};
