// One type for every integer that a formula of doubles reaches: sums and products are not wider types, so that a
// formula is compiled once, whatever its inputs' exponents.
#pragma once

#include <graze/exact/sparse_integer.hpp>

#include <cstdint>

namespace graze::inline v0_1::detail {

// Σ digit_i 2^(64 position_i) as in sparse_integer, |x| < 2^long_width. That the results of a computation stay below is
// the caller's to know: for every factor that comes from lengths, velocities and normals lifted from doubles
// sparse_integer needs 2098 bits. Copies take the digits that are there, not the room for all.
inline constexpr int long_width = 20 * 2112;

class long_integer {
  public:
    static constexpr int capacity = long_width / 64 + 2;

    constexpr long_integer() noexcept : count_(0) {}
    constexpr long_integer(int value) noexcept : long_integer(from_shifted(value, 0)) {}
    constexpr long_integer(const long_integer& x) noexcept : count_(0) { count_ = copy_digits(x.digits(), output()); }
    constexpr long_integer& operator=(const long_integer& x) noexcept {
        count_ = copy_digits(x.digits(), output());
        return *this;
    }

    // significand · 2^shift; 0 <= shift.
    [[nodiscard]] static constexpr long_integer from_shifted(std::int64_t significand, int shift) noexcept {
        const auto x = sparse_integer<192>::from_shifted(significand, shift % 64);
        long_integer r;
        sparse_output out = r.output();
        for (int i = 0; i < x.count(); ++i) {
            out.append(x.position(i) + shift / 64, x.digit(i));
        }
        r.count_ = out.count;
        return r;
    }

    [[nodiscard]] constexpr int count() const noexcept { return count_; }
    [[nodiscard]] constexpr int position(int i) const noexcept { return position_[i]; }
    [[nodiscard]] constexpr std::int64_t digit(int i) const noexcept { return digit_[i]; }
    [[nodiscard]] constexpr int sign() const noexcept { return count_ == 0 ? 0 : digit_[count_ - 1] < 0 ? -1 : 1; }
    [[nodiscard]] constexpr sparse_digits digits() const noexcept { return {count_, position_, digit_}; }

    [[nodiscard, gnu::noinline]] constexpr long_integer operator-() const noexcept {
        return sum_of({0, nullptr, nullptr}, digits(), -1);
    }
    [[nodiscard, gnu::noinline]] friend constexpr long_integer operator+(const long_integer& x,
                                                                         const long_integer& y) noexcept {
        return sum_of(x.digits(), y.digits(), 1);
    }
    [[nodiscard, gnu::noinline]] friend constexpr long_integer operator-(const long_integer& x,
                                                                         const long_integer& y) noexcept {
        return sum_of(x.digits(), y.digits(), -1);
    }
    [[nodiscard, gnu::noinline]] friend constexpr long_integer operator*(const long_integer& x,
                                                                         const long_integer& y) noexcept {
        return product_sum(&x, &y, 1);
    }
    // Σ x_i y_i, in one accumulator.
    [[nodiscard, gnu::noinline]] static constexpr long_integer product_sum(const long_integer* x, const long_integer* y,
                                                                           int terms) noexcept {
        constexpr int words = (capacity + 2) / 64 + 1;
        std::uint64_t touched[words] = {};
        std::int64_t sum[capacity + 2];
        digit_accumulator accumulator(touched, sum);
        int highest = 0;
        for (int i = 0; i < terms; ++i) {
            accumulator.add_product(x[i].digits(), y[i].digits());
            highest = std::max(highest, x[i].top() + y[i].top());
        }
        long_integer r;
        r.count_ = accumulator.write((highest + 3) / 64 + 1, r.output());
        return r;
    }

  private:
    [[nodiscard]] constexpr int top() const noexcept { return count_ == 0 ? 0 : position_[count_ - 1]; }
    [[nodiscard]] constexpr sparse_output output() noexcept { return {0, position_, digit_}; }
    [[nodiscard]] static constexpr long_integer sum_of(const sparse_digits& x, const sparse_digits& y,
                                                       int factor) noexcept {
        long_integer r;
        r.count_ = add_digits(x, y, factor, r.output());
        return r;
    }

    int count_;
    std::int16_t position_[capacity];
    std::int64_t digit_[capacity];
};

} // namespace graze::inline v0_1::detail

template <>
struct graze::number_traits<graze::detail::long_integer> {
    using number = detail::long_integer;
    static constexpr const char* name = "long_integer";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr bool is_integer = true;
    static constexpr int sign(const number& x) noexcept { return x.sign(); }

    template <int N>
    static constexpr number dot(const vec<N, number>& x, const vec<N, number>& y) noexcept {
        return number::product_sum(x.component, y.component, N);
    }
};
