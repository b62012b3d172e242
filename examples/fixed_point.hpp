// A user's own number type: 32.32 fixed point, as in games and on machines without a floating-point unit. Ten lines of
// number_traits make it a graze::number.
#pragma once

#include <graze/number/traits.hpp>

#include <compare>
#include <cstdint>
#include <stdexcept>

// Multiples of 2^-32 below 2^31 in magnitude. Sums are exact. Products, quotients and roots are rounded down to the
// grid. A result that does not fit throws.
class fixed_point {
  public:
    fixed_point() = default;
    constexpr fixed_point(int x) : raw_(std::int64_t{x} * (std::int64_t{1} << 32)) {}
    constexpr explicit fixed_point(double x) : raw_(static_cast<std::int64_t>(x * 0x1p32)) {}

    constexpr explicit operator double() const { return static_cast<double>(raw_) * 0x1p-32; }

    friend constexpr fixed_point operator-(fixed_point x) { return narrow(-wide{x.raw_}); }
    friend constexpr fixed_point operator+(fixed_point x, fixed_point y) { return narrow(wide{x.raw_} + y.raw_); }
    friend constexpr fixed_point operator-(fixed_point x, fixed_point y) { return narrow(wide{x.raw_} - y.raw_); }
    friend constexpr fixed_point operator*(fixed_point x, fixed_point y) {
        return narrow((wide{x.raw_} * y.raw_) >> 32);
    }
    friend constexpr fixed_point operator/(fixed_point x, fixed_point y) {
        if (y.raw_ == 0) {
            throw std::overflow_error("division by zero");
        }
        const wide numerator = wide{x.raw_} * (wide{1} << 32);
        const wide quotient = numerator / y.raw_;
        return narrow(quotient - (quotient * y.raw_ != numerator && (numerator < 0) != (y.raw_ < 0) ? 1 : 0));
    }
    friend constexpr auto operator<=>(fixed_point, fixed_point) = default;

    // The value times 2^32, and the value from that.
    [[nodiscard]] constexpr std::int64_t raw() const { return raw_; }
    static constexpr fixed_point from_raw(std::int64_t raw) {
        fixed_point x;
        x.raw_ = raw;
        return x;
    }

    // Bit by bit, for x >= 0.
    static constexpr fixed_point square_root(fixed_point x) {
        const wide square = wide{x.raw_} << 32;
        wide root = 0;
        for (wide bit = wide{1} << 47; bit != 0; bit >>= 1) {
            if ((root + bit) * (root + bit) <= square) {
                root += bit;
            }
        }
        return narrow(root);
    }

  private:
    __extension__ using wide = __int128;

    static constexpr fixed_point narrow(wide x) {
        if (x != static_cast<std::int64_t>(x)) {
            throw std::overflow_error("beyond 2^31");
        }
        return from_raw(static_cast<std::int64_t>(x));
    }

    std::int64_t raw_ = 0;
};

template <>
struct graze::number_traits<fixed_point> {
    static constexpr const char* name = "fixed 32.32";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0; // errors are absolute, so there is no number of significant digits
    static constexpr fixed_point sqrt(fixed_point x) { return fixed_point::square_root(x); }
};
static_assert(graze::field_number<fixed_point> && graze::has_sqrt<fixed_point>);
