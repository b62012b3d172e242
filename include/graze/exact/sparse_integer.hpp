// Integers with few non-zero digits. Doubles with exponents that are far apart become such integers on a common scale.
#pragma once

#include <graze/exact/integer.hpp>
#include <graze/exact/sparse_digits.hpp>

#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1 {

template <int N, class T>
struct vec;

// An integer x with |x| < 2^Bits as Σ digit_i 2^(64 position_i), with digits in [-2^63, 2^63) and without zero digits.
// A carry is one more digit and does not run through zeros, so 2^2000 - 1 has two digits. The sign is that of the
// highest digit, since all digits below it amount to less than its unit. Widths are those of integer<Bits>. It never
// allocates. The cost of a product depends only on the non-zero digits.
template <int Bits>
class sparse_integer {
  public:
    static constexpr int bits = Bits;
    static constexpr int capacity = Bits / 64 + 2;

    constexpr sparse_integer() noexcept : count_(0) { settle(); }
    constexpr sparse_integer(int value) noexcept : sparse_integer(from_shifted(value, 0)) {}

    template <int B>
    requires(B < Bits) constexpr sparse_integer(const sparse_integer<B>& x) noexcept : sparse_integer() {
        count_ = detail::copy_digits(x.digits(), output());
    }

    // significand · 2^shift, shift >= 0. The caller knows that it fits.
    [[nodiscard]] static constexpr sparse_integer from_shifted(std::int64_t significand, int shift) noexcept {
        sparse_integer r;
        const int word = shift / 64;
        const int bit = shift % 64; // 2^63 is not a digit, so the power is split into two factors
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

    // Appends a digit above all others. A zero is omitted.
    constexpr void append(int position, std::int64_t digit) noexcept {
        if (digit != 0) {
            position_[count_] = static_cast<std::int16_t>(position);
            digit_[count_] = digit;
            ++count_;
        }
    }

    [[nodiscard]] constexpr sparse_integer operator-() const noexcept;

    [[nodiscard]] constexpr detail::sparse_digits digits() const noexcept { return {count_, position_, digit_}; }

    // x + factor·y, and the sum that fill(accumulator) adds up. The caller knows that they fit. For the arithmetic
    // below.
    [[nodiscard]] static constexpr sparse_integer sum_of(const detail::sparse_digits& x, const detail::sparse_digits& y,
                                                         int factor) noexcept {
        sparse_integer r;
        r.count_ = detail::add_digits(x, y, factor, r.output());
        return r;
    }
    template <class Fill>
    [[nodiscard]] static constexpr sparse_integer sum_of_products(Fill fill) noexcept {
        constexpr int words = (capacity + 2) / 64 + 1;
        std::uint64_t touched[words] = {};
        std::int64_t sum[capacity + 2];
        detail::digit_accumulator accumulator(touched, sum);
        fill(accumulator);
        sparse_integer r;
        r.count_ = accumulator.write(words, r.output());
        return r;
    }

  private:
    [[nodiscard]] constexpr detail::sparse_output output() noexcept { return {0, position_, digit_}; }

    // A constant expression may only copy initialised digits.
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

template <int Bits>
constexpr sparse_integer<Bits> sparse_integer<Bits>::operator-() const noexcept {
    return sum_of({0, nullptr, nullptr}, digits(), -1);
}

template <int A, int B>
[[nodiscard]] constexpr auto operator+(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
    return sparse_integer<(A > B ? A : B) + 1>::sum_of(x.digits(), y.digits(), 1);
}
template <int A, int B>
[[nodiscard]] constexpr auto operator-(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
    return sparse_integer<(A > B ? A : B) + 1>::sum_of(x.digits(), y.digits(), -1);
}

template <int A, int B>
[[nodiscard]] constexpr auto operator*(const sparse_integer<A>& x, const sparse_integer<B>& y) noexcept {
    return sparse_integer<A + B>::sum_of_products(
        [&](detail::digit_accumulator& sum) { sum.add_product(x.digits(), y.digits()); });
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
        return sparse_integer<Bits + B + 2>::sum_of_products([&](detail::digit_accumulator& sum) {
            for (int i = 0; i < N; ++i) {
                sum.add_product(x[i].digits(), y[i].digits());
            }
        });
    }
};

} // namespace graze::inline v0_1
