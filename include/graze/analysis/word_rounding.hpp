// What a formula of sums and products loses in loose double words.
#pragma once

#include <graze/number/traits.hpp>

namespace graze::inline v0_1::detail {

// A value stands for an exact one whose terms' magnitudes add up to S (term_size): |low| <= low u S, and |exact
// - (high + low)| <= error u² S, u = 2^-53, to nearest. |high| <= (1 + 2^-40) S.
//   Sums: the low parts, at most l u S in all, and the error of the high parts' sum, at most u S, are added with two
//     roundings of at most l u² S and (l + 1) u² S.
//   Products: low·low is left out; the two products of one high and one low part, together (l + m) u S, take
//     two roundings, and adding the error of the
//     high parts' product takes one more.
// A sum's `low` and `error` are the larger of its terms': each counts against its own terms.
struct word_rounding {
    double low = 0;
    double error = 0;

    constexpr word_rounding() = default;
    constexpr word_rounding(double l, double e) : low(l), error(e) {}
    constexpr explicit word_rounding(int) {}
    // A double, and an exact sum or difference of two.
    [[nodiscard]] static constexpr word_rounding exact_double() { return {0, 0}; }
    [[nodiscard]] static constexpr word_rounding exact_input() { return {1, 0}; }

    // error u², with room for the roundings of this product and of S, and for terms of the order u³.
    [[nodiscard]] constexpr double bound() const { return (1 + 0x1p-40) * 0x1p-106 * error; }

    [[nodiscard]] friend constexpr word_rounding operator-(const word_rounding& x) { return x; }
    [[nodiscard]] friend constexpr word_rounding operator+(const word_rounding& x, const word_rounding& y) {
        const double l = x.low > y.low ? x.low : y.low;
        return {l + 1, (x.error > y.error ? x.error : y.error) + 2 * l + 1};
    }
    [[nodiscard]] friend constexpr word_rounding operator-(const word_rounding& x, const word_rounding& y) {
        return x + y;
    }
    [[nodiscard]] friend constexpr word_rounding operator*(const word_rounding& x, const word_rounding& y) {
        const double l = x.low + y.low;
        return {l + 1, x.error + y.error + x.low * y.low + 2 * l + (l + 1)};
    }
};

} // namespace graze::inline v0_1::detail

template <>
struct graze::number_traits<graze::detail::word_rounding> {
    static constexpr const char* name = "word_rounding";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
    static constexpr int sign(const detail::word_rounding&) { return 1; }
};
