// An unevaluated sum of two doubles: about 106 bits with the exponents of double.
#pragma once

#include <graze/machine/error_free.hpp>
#include <graze/number/floating.hpp>

#include <compare>

namespace graze::inline v0_1 {

// high + low with high = RN(high + low). The bounds beside the operations are relative to the exact result, with u =
// 2^-53, proved by Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
// double-word arithmetic", ACM TOMS 44(2), 2017 (their theorems are cited by algorithm), and in Coq by Muller and
// Rideau, ACM TOMS 48(1), 2022. They hold where error-free transforms do (machine/error_free.hpp): doubles rounded to
// nearest, nothing over- or underflows, products and quotients not below 2^-916. With fused multiply-adds (Fused) or
// without.
template <bool Fused>
class basic_double_word {
    using double_word = basic_double_word;

  public:
    constexpr basic_double_word() = default;
    constexpr explicit(false) basic_double_word(double x) noexcept : high_(x) {}
    constexpr explicit(false) basic_double_word(int x) noexcept : high_(x) {}
    // value + error, where value must be the nearest double.
    constexpr explicit basic_double_word(const exact_pair<double>& x) noexcept : high_(x.value), low_(x.error) {}
    // a + b, exactly.
    [[nodiscard]] static constexpr double_word sum(double a, double b) noexcept { return double_word(two_sum(a, b)); }
    // a b, exactly.
    [[nodiscard]] static constexpr double_word product(double a, double b) noexcept {
        return double_word(two_product(detail::as_factor<Fused>(a), detail::as_factor<Fused>(b)));
    }

    [[nodiscard]] constexpr double high() const noexcept { return high_; }
    [[nodiscard]] constexpr double low() const noexcept { return low_; }
    // The nearest double.
    [[nodiscard]] constexpr explicit operator double() const noexcept { return high_; }

    [[nodiscard, gnu::always_inline]] friend constexpr inline double_word operator-(const double_word& x) noexcept {
        return double_word({-x.high_, -x.low_});
    }

    // 2x, exactly.
    [[nodiscard]] constexpr double_word doubled() const noexcept { return double_word({high_ + high_, low_ + low_}); }

    // 3u² + 13u³, whatever cancels (AccurateDWPlusDW, Algorithm 6).
    [[nodiscard, gnu::always_inline]] friend constexpr inline double_word operator+(const double_word& x,
                                                                                    const double_word& y) noexcept {
        const auto s = two_sum(x.high_, y.high_);
        const auto t = two_sum(x.low_, y.low_);
        const auto v = fast_two_sum(s.value, detail::settled(s.error + t.value));
        return double_word(fast_two_sum(v.value, detail::settled(t.error + v.error)));
    }
    [[nodiscard, gnu::always_inline]] friend constexpr inline double_word operator-(const double_word& x,
                                                                                    const double_word& y) noexcept {
        return x + -y;
    }

    // 7u² (DWTimesDW1, Algorithm 10); with the inner sum fused 6u² (DWTimesDW2, Algorithm 11).
    [[nodiscard, gnu::always_inline]] friend constexpr inline double_word operator*(const double_word& x,
                                                                                    const double_word& y) noexcept {
        const auto c = two_product(detail::as_factor<Fused>(x.high_), detail::as_factor<Fused>(y.high_));
        const double cross = detail::settled(x.high_ * y.low_ + x.low_ * y.high_);
        return double_word(fast_two_sum(c.value, detail::settled(c.error + cross)));
    }

    // 15u² + 56u³ (DWDivDW2, Algorithm 17).
    [[nodiscard, gnu::always_inline]] friend constexpr inline double_word operator/(const double_word& x,
                                                                                    const double_word& y) noexcept {
        const double quotient = detail::settled(x.high_ / y.high_);
        const double_word back = times(y, quotient);
        const double high = detail::settled(x.high_ - back.high_);
        const double low = detail::settled(x.low_ - back.low_);
        const double rest = detail::settled(high + low);
        return double_word(fast_two_sum(quotient, detail::settled(rest / y.high_)));
    }

    // 25/8 u² (SQRTDWtoDW of Lefèvre, Louvet, Muller, Picot and Rideau, ACM TOMS 49(1), 2023). The root of a negative
    // number is a NaN.
    [[nodiscard, gnu::always_inline]] constexpr inline double_word square_root() const noexcept {
        const double root = detail::settled(number_traits<double>::sqrt(high_));
        if (!(high_ > 0)) {
            return root;
        }
        const auto square = two_square(detail::as_factor<Fused>(root));
        const double rest = detail::settled(detail::settled(high_ - square.value) - square.error);
        return double_word(
            fast_two_sum(root, detail::settled(detail::settled(low_ + rest) / detail::settled(root + root))));
    }
    [[nodiscard, gnu::always_inline]] friend constexpr inline double_word sqrt(const double_word& x) noexcept {
        return x.square_root();
    }

    [[nodiscard]] friend constexpr bool operator==(const double_word& x, const double_word& y) noexcept {
        return x.high_ == y.high_ && x.low_ == y.low_;
    }
    [[nodiscard]] friend constexpr std::partial_ordering operator<=>(const double_word& x,
                                                                     const double_word& y) noexcept {
        const auto order = x.high_ <=> y.high_;
        return order == 0 ? x.low_ <=> y.low_ : order;
    }

  private:
    // x y with 3/2 u² + 4u³ (DWTimesFP1, Algorithm 7).
    [[nodiscard, gnu::always_inline]] static constexpr inline double_word times(const double_word& x,
                                                                                double y) noexcept {
        const auto c = two_product(detail::as_factor<Fused>(x.high_), detail::as_factor<Fused>(y));
        const auto t = fast_two_sum(c.value, detail::settled(x.low_ * y));
        return double_word(fast_two_sum(t.value, detail::settled(t.error + c.error)));
    }

    double high_ = 0;
    double low_ = 0;
};

using double_word = basic_double_word<detail::has_fused_multiply_add>;

template <bool Fused>
struct number_traits<basic_double_word<Fused>> {
    using double_word = basic_double_word<Fused>;
    static constexpr const char* name = "double_word";
    static constexpr bool is_exact = false;
    static constexpr int digits = 103; // the worst operation, a quotient: 15u² < 2^-102
    static constexpr int sign(const double_word& x) noexcept { return (x.high() > 0) - (x.high() < 0); }
    static constexpr double_word sqrt(const double_word& x) noexcept { return x.square_root(); }
    static constexpr double_word twice(const double_word& x) noexcept { return x.doubled(); }
};

} // namespace graze::inline v0_1
