// A double that knows how far it can be from the number it stands for, in any rounding mode.
#pragma once

#include <graze/filter/scaled_filter.hpp>
#include <graze/number/traits.hpp>

namespace graze::inline v0_1::detail {

// |exact - value| <= error. u = 2^-52, contracted or not; the slack covers the roundings of the error itself. A product
// that underflows loses less than 2^-1000.
class bounded_double {
  public:
    constexpr bounded_double() = default;
    constexpr explicit(false) bounded_double(int x) noexcept : value_(x) {}
    constexpr explicit bounded_double(double x) noexcept : value_(x) {}

    // -1 or 1 where it is certain, 0 where not.
    [[nodiscard]] constexpr int certain_sign() const noexcept {
        return value_ > error_ ? 1 : value_ < -error_ ? -1 : 0;
    }

    [[nodiscard]] friend constexpr bounded_double operator-(const bounded_double& x) noexcept {
        return {-x.value_, x.error_};
    }
    [[nodiscard]] friend constexpr bounded_double operator+(const bounded_double& x, const bounded_double& y) noexcept {
        const double sum = x.value_ + y.value_;
        return {sum, slack * (x.error_ + y.error_ + 0x1p-52 * magnitude_of(sum))};
    }
    [[nodiscard]] friend constexpr bounded_double operator-(const bounded_double& x, const bounded_double& y) noexcept {
        return x + -y;
    }
    [[nodiscard]] friend constexpr bounded_double operator*(const bounded_double& x, const bounded_double& y) noexcept {
        const double product = x.value_ * y.value_;
        return {product, slack * (magnitude_of(x.value_) * y.error_ + (magnitude_of(y.value_) + y.error_) * x.error_ +
                                  0x1p-52 * magnitude_of(product)) +
                             0x1p-1000};
    }

  private:
    static constexpr double slack = 1 + 0x1p-40;

    constexpr bounded_double(double value, double error) noexcept : value_(value), error_(error) {}

    double value_ = 0;
    double error_ = 0;
};

} // namespace graze::inline v0_1::detail

template <>
struct graze::number_traits<graze::detail::bounded_double> {
    static constexpr const char* name = "bounded_double";
    static constexpr bool is_exact = false;
    static constexpr int digits = 52;
    // Of what is not 0 but by chance: only the flat decision's own zero radius is asked.
    static constexpr int sign(const detail::bounded_double& x) noexcept { return x.certain_sign(); }
};
