// Integers of any size: one type for all formulas whose inputs have more than a limb.
//
// With integer<Bits> every width is a type: that is fast and makes overflow impossible, but each formula is compiled
// once per width. Where that costs more than it gains, the width is a value at run time.
#pragma once

#include <graze/exact/digits.hpp>
#include <graze/exact/integer.hpp>
#include <graze/exact/workspace.hpp>
#include <graze/number/traits.hpp>

#include <cstdint>

namespace graze::inline v0_1 {

template <int N, class T>
struct vec;

namespace detail {

// ± Σ digit_i 2^(64 (low + i)) with digits in [-2^63, 2^63), the first and the last not 0. The sign is that of the last
// digit, since all others amount to less than its unit. A sum of numbers with exponents far apart has zeros in between,
// which cost a product nothing. It is a value: its digits are in a workspace or are constants, and never change.
class big_integer {
  public:
    constexpr big_integer() noexcept = default;
    // A constant, -4 to 4, which needs no workspace.
    constexpr big_integer(int value) noexcept
        : digit_(small + (value < 0 ? -value : value)), count_(value != 0 ? 1 : 0), negative_(value < 0) {}

    // significand · 2^shift; shift >= 0.
    [[nodiscard, gnu::noinline]] static constexpr big_integer from_shifted(workspace& w, std::int64_t significand,
                                                                           int shift) noexcept {
        if (significand == 0) {
            return {};
        }
        std::int64_t* const digit = w.take(2);
        write_shifted(digit, significand, shift % 64);
        return big_integer(&w, digit, 2, shift / 64, false);
    }

    // From limbs in two's complement, the lowest first.
    [[nodiscard, gnu::noinline]] static constexpr big_integer from_limbs(workspace& w, const std::uint64_t* limb,
                                                                         int count) noexcept {
        std::int64_t* const digit = w.take(count + 1);
        write_limbs(digit, limb, count);
        return big_integer(&w, digit, count + 1, 0, false);
    }

    [[nodiscard]] constexpr int sign() const noexcept {
        return count_ == 0 ? 0 : (digit_[count_ - 1] < 0) != negative_ ? -1 : 1;
    }
    [[nodiscard]] constexpr int count() const noexcept { return count_; }
    [[nodiscard]] constexpr int low() const noexcept { return low_; }
    // A digit of x or, if is_negated, of -x.
    [[nodiscard]] constexpr std::int64_t digit(int i) const noexcept { return digit_[i]; }
    [[nodiscard]] constexpr bool is_negated() const noexcept { return negative_; }
    [[nodiscard]] constexpr workspace* room() const noexcept { return room_; }

    [[nodiscard]] constexpr big_integer operator-() const noexcept {
        big_integer r = *this;
        r.negative_ = !negative_;
        return r;
    }

    [[nodiscard]] friend constexpr big_integer operator+(const big_integer& x, const big_integer& y) noexcept {
        return sum(x, y, false);
    }
    [[nodiscard]] friend constexpr big_integer operator-(const big_integer& x, const big_integer& y) noexcept {
        return sum(x, y, true);
    }

    // x + y, or x - y.
    [[nodiscard, gnu::noinline]] static constexpr big_integer sum(const big_integer& x, const big_integer& y,
                                                                  bool subtract) noexcept {
        if (x.count_ == 0 || y.count_ == 0) {
            return y.count_ == 0 ? x : subtract ? -y : y;
        }
        if (x.room_ == nullptr && y.room_ == nullptr) {
            return constant(subtract ? x.small_value() - y.small_value() : x.small_value() + y.small_value());
        }
        const bool first = x.low_ <= y.low_; // the sum is ±(lower ± upper)
        const big_integer& lower = first ? x : y;
        const big_integer& upper = first ? y : x;
        const bool negative = first ? x.negative_ : y.negative_ != subtract;
        const int shift = upper.low_ - lower.low_;
        const int end = upper.count_ + shift;
        const int count = lower.count_ > end ? lower.count_ : end;
        workspace& w = *(x.room_ != nullptr ? x.room_ : y.room_);
        std::int64_t* const digit = w.take(count + 1);
        write_sum(digit, lower.row(), upper.row(), shift, (x.negative_ != y.negative_) != subtract);
        return big_integer(&w, digit, count + 1, lower.low_, negative);
    }

    [[nodiscard, gnu::noinline]] friend constexpr big_integer operator*(const big_integer& x,
                                                                        const big_integer& y) noexcept {
        if (x.count_ == 0 || y.count_ == 0) {
            return {};
        }
        if (x.room_ == nullptr && y.room_ == nullptr) {
            return constant(x.small_value() * y.small_value());
        }
        workspace& w = *(x.room_ != nullptr ? x.room_ : y.room_);
        const int count = x.count_ + y.count_;
        std::int64_t* const digit = w.take(count);
        write_product(digit, x.row(), y.row());
        return big_integer(&w, digit, count, x.low_ + y.low_, x.negative_ != y.negative_);
    }

    struct term {
        const big_integer* x;
        const big_integer* y;
        bool subtracted = false;
    };

    // Σ ± x y, the terms added up where they stand.
    [[nodiscard, gnu::noinline]] static constexpr big_integer sum_of_products(const term* terms, int count) noexcept {
        int low = 0x7fff;
        int end = 0;
        int total = 0; // of constants
        workspace* room = nullptr;
        for (int k = 0; k < count; ++k) {
            const big_integer& x = *terms[k].x;
            const big_integer& y = *terms[k].y;
            if (x.count_ == 0 || y.count_ == 0) { // a zero has no place
                continue;
            }
            const int start = x.low_ + y.low_;
            const int top = start + x.count_ + y.count_;
            low = start < low ? start : low;
            end = top > end ? top : end;
            if (workspace* const here = x.room_ != nullptr ? x.room_ : y.room_; here != nullptr) {
                room = here;
            } else {
                total += (terms[k].subtracted ? -1 : 1) * x.small_value() * y.small_value();
            }
        }
        if (end == 0) {
            return {};
        }
        if (room == nullptr) {
            return constant(total);
        }
        const int size = end - low + 1;
        std::int64_t* const sum = room->take(size);
        for (int i = 0; i < size; ++i) {
            sum[i] = 0;
        }
        for (int k = 0; k < count; ++k) {
            const big_integer& x = *terms[k].x;
            const big_integer& y = *terms[k].y;
            if (x.count_ != 0 && y.count_ != 0) {
                const bool minus = (x.negative_ != y.negative_) != terms[k].subtracted;
                add_product(sum + (x.low_ + y.low_ - low), x.row(), y.row(), minus);
            }
        }
        return big_integer(room, sum, size, low, false);
    }

  private:
    // From digits taken from the workspace: drops zeros at both ends and keeps the rest.
    constexpr big_integer(workspace* w, std::int64_t* digit, int count, int low, bool negative) noexcept {
        while (count > 0 && digit[count - 1] == 0) {
            --count;
        }
        if (count == 0) {
            return;
        }
        room_ = w;
        w->keep_until(digit + count);
        while (*digit == 0) {
            ++digit;
            ++low;
            --count;
        }
        digit_ = digit;
        count_ = static_cast<std::int16_t>(count);
        low_ = static_cast<std::int16_t>(low);
        negative_ = negative;
    }

    [[nodiscard]] static constexpr big_integer constant(int value) noexcept {
        if (value < -4 || value > 4) {
            std::terminate(); // no formula reaches this
        }
        return value;
    }
    [[nodiscard]] constexpr int small_value() const noexcept {
        return count_ == 0 ? 0 : static_cast<int>(negative_ ? -digit_[0] : digit_[0]);
    }

    [[nodiscard]] constexpr digit_row row() const noexcept { return {digit_, count_}; }

    static constexpr std::int64_t small[5] = {0, 1, 2, 3, 4};

    workspace* room_ = nullptr;
    const std::int64_t* digit_ = nullptr;
    std::int16_t count_ = 0;
    std::int16_t low_ = 0;
    bool negative_ = false;
};

// x, in a workspace.
template <int Bits>
[[nodiscard, gnu::noinline]] constexpr big_integer to_big(workspace& w, const integer<Bits>& x) noexcept {
    std::uint64_t limb[integer<Bits>::limbs];
    for (int i = 0; i < integer<Bits>::limbs; ++i) {
        limb[i] = x.limb(i);
    }
    return big_integer::from_limbs(w, limb, integer<Bits>::limbs);
}

} // namespace detail

template <>
struct number_traits<detail::big_integer> {
    static constexpr const char* name = "big_integer";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const detail::big_integer& x) noexcept { return x.sign(); }

    template <int N>
    static constexpr auto dot(const vec<N, detail::big_integer>& x, const vec<N, detail::big_integer>& y) noexcept {
        detail::big_integer::term terms[3] = {{&x[0], &y[0]}, {&x[1], &y[1]}, {&x[N - 1], &y[N - 1]}};
        return detail::big_integer::sum_of_products(terms, N);
    }
    template <class Vec>
    static constexpr auto cross(const Vec& x, const Vec& y) noexcept {
        const auto determinant = [&](int i, int j) {
            const detail::big_integer::term terms[2] = {{&x[i], &y[j]}, {&x[j], &y[i], true}};
            return detail::big_integer::sum_of_products(terms, 2);
        };
        if constexpr (requires(vec<3, detail::big_integer> v) { v = x; }) {
            return Vec{{determinant(1, 2), determinant(2, 0), determinant(0, 1)}};
        } else {
            return determinant(0, 1);
        }
    }
};

} // namespace graze::inline v0_1
