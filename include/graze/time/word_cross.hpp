// Δx × Δu in double words, each component with a proven error.
//
// u = 2^-53, doubles to nearest. Errors are upper bounds, with room for the roundings of their own expressions.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/number/loose_word.hpp>
#include <graze/pair/sized_motion.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

// a b - c d. With M = |a b| + |c d|, and `low` the products of one high and one low part each, whose sizes add up to l:
// the high parts lose 11u³ M; low takes 3 roundings, 3 more in adding it up, and leaves out the products of low parts,
// at most u l: 7u l. The last sum but one rounds a number of at most u |a b - c d| and l: u² |a b - c d|.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded_value<loose_word<Fused>>
difference_of_products(const loose_word<Fused>& a, const loose_word<Fused>& b, const loose_word<Fused>& c,
                       const loose_word<Fused>& d) noexcept {
    const auto p = two_product(as_factor<Fused>(a.high), as_factor<Fused>(b.high));
    const auto q = two_product(as_factor<Fused>(c.high), as_factor<Fused>(d.high));
    const auto high = two_difference(p.value, q.value);
    const auto error = two_difference(p.error, q.error);
    const double l0 = a.high * b.low, l1 = a.low * b.high, l2 = c.high * d.low, l3 = c.low * d.high;
    const auto middle = two_sum(high.error, error.value);
    const auto sum = two_sum(high.value, middle.value);
    const double rest = settled(middle.error + error.error) + settled((l0 + l1) - (l2 + l3));
    const loose_word<Fused> value(two_sum(sum.value, settled(sum.error + settled(rest))));
    return {value, 0x1p-50 * ((std::fabs(l0) + std::fabs(l1)) + (std::fabs(l2) + std::fabs(l3))) +
                       (0x1p-104 * std::fabs(value.high) + 0x1p-154 * (std::fabs(p.value) + std::fabs(q.value)))};
}

// Δx × Δu, and the sum of the errors of its components.
template <bool Fused, int N>
struct word_cross;
template <bool Fused>
struct word_cross<Fused, 2> {
    using word = loose_word<Fused>;
    word value;
    double error = 0, moved = 0; // moved: the error of its square

    word_cross() = default;

    // off: what x is off by, times what y is.
    [[gnu::always_inline]] word_cross(const vec<2, word>& x, const vec<2, word>& y, double off) noexcept {
        const auto z = difference_of_products(x[0], y[1], x[1], y[0]);
        value = z.value;
        error = z.error + off;
        moved = error * (2 * std::fabs(value.high) + error);
    }
    [[nodiscard, gnu::always_inline]] double size() const noexcept { return std::fabs(value.high); }

    // Over a, and what the quotient can be off by: `relative` of it, and what the product is off by over a.
    [[nodiscard, gnu::always_inline]] word over(const word& per_a) const noexcept { return value * per_a; }
    [[nodiscard, gnu::always_inline]] double errors_over(const word& quotient, double relative,
                                                         double per_a) const noexcept {
        return relative * std::fabs(quotient.high) + error * per_a;
    }
};
template <bool Fused>
struct word_cross<Fused, 3> {
    using word = loose_word<Fused>;
    vec<3, word> value;
    vec<3, double> each{}; // of each component
    double error = 0, moved = 0;

    word_cross() = default;

    [[gnu::always_inline]] word_cross(const vec<3, word>& x, const vec<3, word>& y, double off) noexcept {
        const auto z0 = difference_of_products(x[1], y[2], x[2], y[1]);
        const auto z1 = difference_of_products(x[2], y[0], x[0], y[2]);
        const auto z2 = difference_of_products(x[0], y[1], x[1], y[0]);
        value = {{z0.value, z1.value, z2.value}};
        each = {{z0.error + off, z1.error + off, z2.error + off}};
        error = ((z0.error + z1.error) + z2.error) + off;
        moved = error * (2 * size() + error);
    }
    [[nodiscard, gnu::always_inline]] double size() const noexcept {
        return (std::fabs(value[0].high) + std::fabs(value[1].high)) + std::fabs(value[2].high);
    }
    [[nodiscard, gnu::always_inline]] vec<3, word> over(const word& per_a) const noexcept {
        return {{value[0] * per_a, value[1] * per_a, value[2] * per_a}};
    }
    [[nodiscard, gnu::always_inline]] vec<3, double> errors_over(const vec<3, word>& quotient, double relative,
                                                                 double per_a) const noexcept {
        return make_vec<3>([&](int i) { return relative * std::fabs(quotient[i].high) + each[i] * per_a; });
    }
};

} // namespace graze::inline v0_1::detail
