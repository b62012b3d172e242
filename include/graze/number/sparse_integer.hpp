// Integers with few non-zero digits: what doubles whose exponents lie far apart are when lifted to one scale.
#pragma once

#include <graze/number/integer.hpp>

#include <algorithm>
#include <type_traits>

namespace graze {

template <int N, class T>
struct vec;

// An integer x with |x| < 2^Bits as Σ digit_i 2^(64 position_i), the digits in [-2^63, 2^63), zero digits left out. A
// carry is one more digit and does not run through zeros, so that 2^2000 - 1 has two digits. The sign is that of the
// highest digit, since all below it amount to less than its unit. Same widths as integer<Bits>; never allocates. The
// cost of a product is that of its non-zero digits.
template <int Bits>
class sparse_integer {
  public:
    static constexpr int bits = Bits;
    static constexpr int capacity = Bits / 64 + 2;

    constexpr sparse_integer() noexcept : count_(0) { settle(); }
    constexpr sparse_integer(int value) noexcept : sparse_integer(from_shifted(value, 0)) {}

    template <int B>
    requires(B < Bits) constexpr sparse_integer(const sparse_integer<B>& x) noexcept : sparse_integer() {
        for (int i = 0; i < x.count(); ++i) {
            append(x.position(i), x.digit(i));
        }
    }

    // significand · 2^shift, of which the caller knows that it fits; 0 <= shift.
    [[nodiscard]] static constexpr sparse_integer from_shifted(std::int64_t significand, int shift) noexcept {
        sparse_integer r;
        const int word = shift / 64;
        const int bit = shift % 64; // 2^63 is not a digit, so that the power is taken in two factors
        const auto half = detail::multiply_add_balanced(significand, std::int64_t{1} << bit / 2, 0, 0);
        const auto low = detail::multiply_add_balanced(half.low, std::int64_t{1} << (bit - bit / 2), 0, 0);
        r.append(word, low.low);
        r.append(word + 1, half.high * (std::int64_t{1} << (bit - bit / 2)) + low.high);
        return r;
    }

    [[nodiscard]] constexpr int count() const noexcept { return count_; }
    [[nodiscard]] constexpr int position(int i) const noexcept { return position_[i]; }
    [[nodiscard]] constexpr std::int64_t digit(int i) const noexcept { return digit_[i]; }
    [[nodiscard]] constexpr int sign() const noexcept { return count_ == 0 ? 0 : digit_[count_ - 1] < 0 ? -1 : 1; }

    // Adds a digit above all others; a zero is left out.
    constexpr void append(int position, std::int64_t digit) noexcept {
        if (digit != 0) {
            position_[count_] = static_cast<std::int16_t>(position);
            digit_[count_] = digit;
            ++count_;
        }
    }

    [[nodiscard]] constexpr sparse_integer operator-() const noexcept;

  private:
    // In a constant expression what is copied has a value.
    constexpr void settle() noexcept {
        if (std::is_constant_evaluated()) {
            for (int i = 0; i < capacity; ++i) {
                position_[i] = 0;
                digit_[i] = 0;
            }
        }
    }

    int count_;
    std::int16_t position_[capacity];
    std::int64_t digit_[capacity];
};

namespace detail {

// x + factor·y for factor 1 or -1, digit by digit from the lowest.
template <class R, int A, int B>
[[nodiscard]] constexpr R sparse_sum(const sparse_integer<A>& x, const sparse_integer<B>& y, int factor) noexcept {
    R r;
    int i = 0;
    int j = 0;
    std::int64_t carry = 0;
    int carry_position = 0;
    while (i < x.count() || j < y.count() || carry != 0) {
        int p = carry != 0 ? carry_position : 0x7fff;
        p = i < x.count() ? std::min(p, x.position(i)) : p;
        p = j < y.count() ? std::min(p, y.position(j)) : p;
        const std::int64_t from_x = i < x.count() && x.position(i) == p ? x.digit(i++) : 0;
        const std::int64_t from_y = j < y.count() && y.position(j) == p ? y.digit(j++) : 0;
        const std::int64_t carried = carry != 0 && carry_position == p ? carry : 0;
        const auto t = multiply_add_balanced(from_y, factor, from_x, carried);
        r.append(p, t.low);
        carry = t.high;
        carry_position = p + 1;
    }
    return r;
}

} // namespace detail

template <int Bits>
constexpr sparse_integer<Bits> sparse_integer<Bits>::operator-() const noexcept {
    return detail::sparse_sum<sparse_integer>(sparse_integer<1>(), *this, -1);
}

template <int A, int B>
[[nodiscard]] constexpr auto operator+(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
    return detail::sparse_sum<sparse_integer<(A > B ? A : B) + 1>>(x, y, 1);
}
template <int A, int B>
[[nodiscard]] constexpr auto operator-(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
    return detail::sparse_sum<sparse_integer<(A > B ? A : B) + 1>>(x, y, -1);
}

namespace detail {

// Digits summed up in place, with a mask of the positions that were touched.
template <int Capacity>
class digit_accumulator {
  public:
    constexpr digit_accumulator() noexcept : touched_{} {}

    // Adds x·y, row by row.
    template <int A, int B>
    constexpr void add_product(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
        for (int i = 0; i < x.count(); ++i) {
            std::int64_t carry = 0;
            int next = -1;
            for (int j = 0; j < y.count(); ++j) {
                const int p = x.position(i) + y.position(j);
                if (p != next) {
                    deposit(next, carry);
                    carry = 0;
                }
                const auto t = multiply_add_balanced(x.digit(i), y.digit(j), at(p), carry);
                sum_[p] = t.low;
                carry = t.high;
                next = p + 1;
            }
            deposit(next, carry);
        }
    }

    template <class R>
    [[nodiscard]] constexpr R result() const noexcept {
        R r;
        for (int word = 0; word < words; ++word) {
            for (std::uint64_t rest = touched_[word]; rest != 0; rest &= rest - 1) {
                const int p = 64 * word + std::countr_zero(rest);
                r.append(p, sum_[p]);
            }
        }
        return r;
    }

  private:
    static constexpr int words = Capacity / 64 + 1;

    // The digit at p, 0 when it is touched for the first time.
    [[nodiscard]] constexpr std::int64_t at(int p) noexcept {
        const std::uint64_t bit = std::uint64_t{1} << (p % 64);
        std::uint64_t& word = touched_[p / 64];
        if ((word & bit) == 0) {
            word |= bit;
            return 0;
        }
        return sum_[p];
    }

    constexpr void deposit(int p, std::int64_t carry) noexcept {
        while (carry != 0) {
            const auto t = multiply_add_balanced(0, 0, at(p), carry);
            sum_[p++] = t.low;
            carry = t.high;
        }
    }

    std::uint64_t touched_[words];
    std::int64_t sum_[Capacity];
};

} // namespace detail

template <int A, int B>
[[nodiscard]] constexpr auto operator*(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
    using product = sparse_integer<A + B>;
    detail::digit_accumulator<product::capacity + 2> sum;
    sum.add_product(x, y);
    return sum.template result<product>();
}

template <int Bits>
struct number_traits<sparse_integer<Bits>> {
    static constexpr const char* name = "sparse_integer";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const sparse_integer<Bits>& x) noexcept { return x.sign(); }

    // The products of an inner product share one accumulator.
    template <int N, int B>
    static constexpr auto dot(const vec<N, sparse_integer<Bits>>& x, const vec<N, sparse_integer<B>>& y) noexcept {
        using sum_type = sparse_integer<Bits + B + 2>;
        detail::digit_accumulator<sum_type::capacity + 2> sum;
        for (int i = 0; i < N; ++i) {
            sum.add_product(x[i], y[i]);
        }
        return sum.template result<sum_type>();
    }
};

} // namespace graze
