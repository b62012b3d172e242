// A double with a bound on its distance from the number that it stands for.
#pragma once

#include <graze/filter/scaled_filter.hpp>
#include <graze/machine/error_free.hpp>
#include <graze/number/traits.hpp>

namespace graze::inline v0_1::detail {

// |exact - value| <= error, but for the roundings of the error and for underflow, for which certain_sign has room: an
// operation rounds its error at most five times, by less than 2^-49 in all, so fewer than 2^8 operations in a row miss
// at most 2^-41 of it. A rounding is at most a part u = 2^-Bits: Bits is 53 to nearest, 52 in any direction. Contracted
// or not; sums are settled, since a bound holds for the order of its own sums.
template <int Bits>
class bounded_double {
  public:
    constexpr bounded_double() = default;
    constexpr explicit(false) bounded_double(int x) noexcept : value_(x) {}
    constexpr explicit bounded_double(double x) noexcept : value_(x) {}
    constexpr bounded_double(double value, double error) noexcept : value_(value), error_(error) {}

    [[nodiscard]] constexpr double value() const noexcept { return value_; }
    [[nodiscard]] constexpr double error() const noexcept { return error_; }

    // -1 or 1 where it is certain, 0 where not. lost: what underflow may have taken.
    [[nodiscard]] constexpr int certain_sign(double lost) const noexcept {
        const double bound = (1 + 0x1p-40) * error_ + lost;
        return value_ > bound ? 1 : value_ < -bound ? -1 : 0;
    }

    // x - y of numbers without an error, to nearest; it has no error either if it is a double.
    [[nodiscard, gnu::always_inline]] static constexpr bounded_double
    exact_difference(const bounded_double& x, const bounded_double& y) noexcept {
        const auto d = two_difference(x.value_, y.value_);
        return {d.value, magnitude_of(d.error)};
    }

    [[nodiscard, gnu::always_inline]] friend constexpr bounded_double operator-(const bounded_double& x) noexcept {
        return {-x.value_, x.error_};
    }
    [[nodiscard, gnu::always_inline]] friend constexpr bounded_double operator+(const bounded_double& x,
                                                                                const bounded_double& y) noexcept {
        const double sum = settled(x.value_ + y.value_);
        return {sum, x.error_ + y.error_ + u * magnitude_of(sum)};
    }
    [[nodiscard, gnu::always_inline]] friend constexpr bounded_double operator-(const bounded_double& x,
                                                                                const bounded_double& y) noexcept {
        return x + -y;
    }
    [[nodiscard, gnu::always_inline]] friend constexpr bounded_double operator*(const bounded_double& x,
                                                                                const bounded_double& y) noexcept {
        const double product = x.value_ * y.value_;
        return {product, magnitude_of(x.value_) * y.error_ +
                             ((magnitude_of(y.value_) + y.error_) * x.error_ + u * magnitude_of(product))};
    }

  private:
    static constexpr double u = 1.0 / static_cast<double>(std::uint64_t{1} << Bits);

    double value_ = 0;
    double error_ = 0;
};

} // namespace graze::inline v0_1::detail

template <int Bits>
struct graze::number_traits<graze::detail::bounded_double<Bits>> {
    static constexpr const char* name = "bounded_double";
    static constexpr bool is_exact = false;
    static constexpr int digits = Bits;
    // For a number without an error.
    static constexpr int sign(const detail::bounded_double<Bits>& x) noexcept {
        return (x.value() > 0) - (x.value() < 0);
    }
};
