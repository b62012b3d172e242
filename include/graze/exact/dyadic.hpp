// A binary fraction of any length.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/number/traits.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace graze::inline v0_1 {

// An integer of any length times a power of two: sums and products are always exact. It allocates, so it is for rare
// cases without a bound on the length; where the width is known, `integer` is much faster.
class dyadic {
  public:
    [[gnu::noinline]] dyadic(int x = 0) : dyadic(x, 0) {}

    // Exactly x, which must be finite.
    template <std::floating_point T>
    requires is_binary_input<T>
    explicit dyadic(const T& x) : dyadic(detail::split(x).significand, detail::split(x).exponent) {}

    // Functions are out of line: a unit may call them in a hundred places, and no run calls them often.
    [[gnu::noinline]] dyadic(const dyadic& x) : negative_(x.negative_), lowest_(x.lowest_), digits_(x.digits_) {}
    dyadic(dyadic&&) noexcept = default;
    [[gnu::noinline]] dyadic& operator=(const dyadic& x) { return *this = dyadic(x); }
    [[gnu::noinline]] dyadic& operator=(dyadic&& x) noexcept {
        negative_ = x.negative_;
        lowest_ = x.lowest_;
        digits_.swap(x.digits_);
        return *this;
    }
    [[gnu::noinline]] ~dyadic() {}

    // -1, 0 or 1.
    [[nodiscard]] int sign() const noexcept { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

    [[nodiscard, gnu::noinline]] dyadic operator-() const {
        dyadic result = *this;
        result.negative_ = !negative_;
        return result;
    }
    [[nodiscard]] friend dyadic operator+(const dyadic& x, const dyadic& y) { return sum(x, y, y.negative_); }
    [[nodiscard]] friend dyadic operator-(const dyadic& x, const dyadic& y) { return sum(x, y, !y.negative_); }
    [[nodiscard, gnu::noinline]] friend dyadic operator*(const dyadic& x, const dyadic& y) {
        dyadic result;
        result.digits_.resize(x.digits_.size() + y.digits_.size());
        for (std::size_t i = 0; i < x.digits_.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < y.digits_.size() || carry != 0; ++j) {
                carry += result.digits_[i + j];
                carry += j < y.digits_.size() ? std::uint64_t{x.digits_[i]} * y.digits_[j] : 0;
                result.digits_[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
        }
        result.negative_ = x.negative_ != y.negative_;
        result.lowest_ = x.lowest_ + y.lowest_;
        result.trim();
        return result;
    }
    [[nodiscard]] friend bool operator==(const dyadic& x, const dyadic& y) { return (x - y).sign() == 0; }

    // The nearest T towards zero, if it is within T's normal numbers or 0; in any rounding mode.
    template <std::floating_point T>
    requires is_binary_input<T>
    [[nodiscard]] T towards_zero() const noexcept {
        if (digits_.empty()) {
            return T(0);
        }
        std::uint64_t leading = 0; // from the highest bit down
        const int top = end() - 1;
        const int zeros = std::countl_zero(digit(top));
        for (int i = 0; i < 3; ++i) {
            const int shift = 32 - 32 * i + zeros;
            const std::uint64_t bits = digit(top - i);
            leading |= shift >= 0 ? bits << shift : bits >> -shift;
        }
        leading &= ~std::uint64_t{0} << (64 - std::numeric_limits<T>::digits);
        const double value = std::ldexp(static_cast<double>(leading), 32 * top + 32 - zeros - 64);
        return static_cast<T>(negative_ ? -value : value);
    }

  private:
    dyadic(std::int64_t significand, int exponent) : negative_(significand < 0) {
        const int bit = (exponent % 32 + 32) % 32;
        lowest_ = (exponent - bit) / 32;
        std::uint64_t rest =
            negative_ ? 0 - static_cast<std::uint64_t>(significand) : static_cast<std::uint64_t>(significand);
        digits_ = {static_cast<std::uint32_t>(rest << bit), static_cast<std::uint32_t>(rest << bit >> 32),
                   bit != 0 ? static_cast<std::uint32_t>(rest >> (64 - bit)) : 0};
        trim();
    }

    // x + y, with y's sign replaced.
    [[nodiscard, gnu::noinline]] static dyadic sum(const dyadic& x, const dyadic& y, bool y_negative) {
        if (x.digits_.empty() || y.digits_.empty()) {
            dyadic result = x.digits_.empty() ? y : x;
            result.negative_ = x.digits_.empty() ? y_negative : x.negative_;
            return result;
        }
        const int lowest = std::min(x.lowest_, y.lowest_);
        const int end = std::max(x.end(), y.end());
        dyadic result;
        result.lowest_ = lowest;
        result.digits_.reserve(static_cast<std::size_t>(end - lowest) + 1);
        const bool same = x.negative_ == y_negative;
        const bool x_larger = same || !is_less(x, y);
        const dyadic& large = x_larger ? x : y;
        const dyadic& small = x_larger ? y : x;
        std::int64_t carry = 0;
        for (int i = lowest; i < end; ++i) {
            const std::int64_t digit = small.digit(i);
            carry += std::int64_t{large.digit(i)} + (same ? digit : -digit);
            result.digits_.push_back(static_cast<std::uint32_t>(carry));
            carry >>= 32;
        }
        result.digits_.push_back(static_cast<std::uint32_t>(carry));
        result.negative_ = x_larger ? x.negative_ : y_negative;
        result.trim();
        return result;
    }
    // Whether |x| < |y|.
    [[nodiscard]] static bool is_less(const dyadic& x, const dyadic& y) noexcept {
        for (int i = std::max(x.end(), y.end()); i-- > std::min(x.lowest_, y.lowest_);) {
            if (x.digit(i) != y.digit(i)) {
                return x.digit(i) < y.digit(i);
            }
        }
        return false;
    }

    [[nodiscard]] int end() const noexcept { return lowest_ + static_cast<int>(digits_.size()); }
    [[nodiscard]] std::uint32_t digit(int i) const noexcept {
        return i < lowest_ || i >= end() ? 0 : digits_[static_cast<std::size_t>(i - lowest_)];
    }
    // Drops zeros at both ends.
    void trim() {
        while (!digits_.empty() && digits_.back() == 0) {
            digits_.pop_back();
        }
        const auto first = std::find_if(digits_.begin(), digits_.end(), [](std::uint32_t d) { return d != 0; });
        lowest_ += static_cast<int>(first - digits_.begin());
        digits_.erase(digits_.begin(), first);
    }

    bool negative_ = false;
    int lowest_ = 0;                    // the first digit's power of 2^32
    std::vector<std::uint32_t> digits_; // the lowest first
};

template <>
struct number_traits<dyadic> {
    static constexpr const char* name = "dyadic";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static int sign(const dyadic& x) noexcept { return x.sign(); }
};

} // namespace graze::inline v0_1
