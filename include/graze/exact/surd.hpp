// The one rounding routine: rounds (p + q√d)/r to the nearest float or double, downward or upward. Every time,
// position, normal and velocity has this form.
//
// An estimate of 64 bits, with its bound, usually locates the value among the format's boundaries: its numbers and the
// middles between them. In the remaining few per cent of cases, the exact sign of (p - m r) + q√d at the one boundary m
// in question decides, and zero is a tie. Nothing is rounded twice. Only integers are used, and the result is assembled
// from bits: it does not depend on the rounding mode, on flush-to-zero or on compiler flags.
#pragma once

#include <graze/exact/round_leading.hpp>
#include <graze/number/sqrt_extension.hpp>

namespace graze::inline v0_1 {

namespace detail {

template <class I>
struct surd_integers;
template <int Bits>
struct surd_integers<integer<Bits>> {
    static_assert(Bits <= 128);
    using type = integer<Bits <= 64 ? 576 : 1152>;
};
template <int Bits>
struct surd_integers<sparse_integer<Bits>> {
    static_assert(Bits <= 4160);
    using type = sparse_integer<Bits <= 2112 ? 19456 : 38400>;
};

} // namespace detail

// The integer type of p, q, d and r if a pair's lengths and velocities are of type I. Their formulas have up to nine
// factors (an edge's velocities). One type for all of them keeps programs small.
template <class I>
using surd_integer = typename detail::surd_integers<I>::type;

namespace detail {

// The largest quotient, in bits, of the scales of a value and a boundary, either way. The exponent of a boundary is in
// [-1075, 971]. Times have scales up to 2^2098 (lengths up to 2^1023 over velocities from 2^-1074 on), lengths of
// flights down to 2^-3119.
inline constexpr int largest_shift = 3119 + 971;

template <int Bits>
[[nodiscard]] constexpr const sparse_integer<Bits>& to_sparse(const sparse_integer<Bits>& x) noexcept {
    return x;
}
// Balanced digits; one more than there are limbs if the highest one carries.
template <int Bits>
[[nodiscard]] constexpr sparse_integer<Bits> to_sparse(const integer<Bits>& x) noexcept {
    sparse_integer<Bits> r;
    std::uint64_t carry = 0;
    for (int i = 0; i <= integer<Bits>::limbs; ++i) {
        const std::uint64_t limb = x.limb(i) + carry;
        carry = limb < carry || (limb >> 63 != 0 && i < integer<Bits>::limbs) ? 1 : 0;
        r.append(i, static_cast<std::int64_t>(limb));
    }
    return r;
}

// The sign of |p + q√d| 2^scale - m r 2^exponent, given the sign of p + q√d.
template <int Bits>
[[nodiscard]] constexpr int against_boundary(const sparse_integer<Bits>& p, const sparse_integer<Bits>& q,
                                             const sparse_integer<Bits>& d, const sparse_integer<Bits>& r,
                                             bool negative, int scale, std::uint64_t m, int exponent) {
    using power = sparse_integer<largest_shift + 56>;
    const int up = scale - exponent;
    const auto unit = power::from_shifted(negative ? -1 : 1, up > 0 ? up : 0);
    const auto boundary = power::from_shifted(static_cast<std::int64_t>(m), up < 0 ? -up : 0);
    return sign_of_root_sum(p * unit - r * boundary, q * unit, d);
}

// The same for any integer type Z.
template <class Z>
[[nodiscard, gnu::noinline]] constexpr int against_boundary(const Z& p, const Z& q, const Z& d, const Z& r,
                                                            bool negative, int scale, std::uint64_t m, int exponent) {
    return against_boundary(to_sparse(p), to_sparse(q), to_sparse(d), to_sparse(r), negative, scale, m, exponent);
}

// p + q√d where p and q√d cancel, as (p² - q²d)/(p - q√d), whose denominator does not cancel.
template <int Bits>
[[nodiscard]] constexpr leading estimate_by_norm(const sparse_integer<Bits>& p, const sparse_integer<Bits>& q,
                                                 const sparse_integer<Bits>& d, leading first, leading second) {
    leading norm = leading_of(p * p - q * q * d);
    norm.negative = norm.negative != first.negative;
    first.negative = second.negative = false;
    return norm / (first + second);
}

} // namespace detail

// d >= 0 with an estimate of its root, for all numbers of one Q(√d). Z is a surd_integer.
template <class Z>
struct radicand {
    Z value;
    detail::leading root;

    constexpr radicand() noexcept : value(0) {} // for rational numbers
    constexpr explicit radicand(const Z& d) noexcept : value(d), root(detail::square_root(detail::leading_of(value))) {}
};

namespace detail {

// (p + q√d)/r · 2^scale rounded, whatever the leading bits leave open.
template <class T, class Z>
[[nodiscard, gnu::noinline]] constexpr T round_by_sign(const Z& p, const Z& q, const radicand<Z>& d, const Z& r,
                                                       int scale, rounding mode) {
    const leading first = leading_of(p);
    const leading second = leading_of(q) * d.root;
    leading value = first + second;
    if (!value.is_within(largest_error<T>)) {
        value = estimate_by_norm(to_sparse(p), to_sparse(q), to_sparse(d.value), first, second);
    }
    if (value.significand == 0) {
        return from_bits<T>(0, false);
    }
    value = value / leading_of(r);
    value.exponent += scale;
    return round_estimate<T>(value, mode, [&](std::uint64_t m, int exponent) {
        return against_boundary<Z>(p, q, d.value, r, value.negative, scale, m, exponent);
    });
}

} // namespace detail

// (p + q√d)/r · 2^scale rounded to T, float or double. r > 0, -3119 <= scale <= 2098; p, q and r are of any width up to
// that of Z. An exact zero gives +0.
template <class T, class P, class Q, class Z, class R>
[[nodiscard]] constexpr T round_to(const P& p, const Q& q, const radicand<Z>& d, const R& r, int scale,
                                   rounding mode = rounding::nearest) {
    if (const auto certain = detail::round_leading<T>(detail::leading_of(p), detail::leading_of(q), d.root,
                                                      detail::leading_of(r), scale, mode)) {
        return *certain;
    }
    return detail::round_by_sign<T, Z>(p, q, d, r, scale, mode);
}

// The same for p and q√d of different signs, if norm = (p² - q²d)/r is known: the value is norm/(p - q√d), in which
// nothing cancels.
template <class T, class P, class Q, class Z, class R, class C>
[[nodiscard]] constexpr T round_to_by_norm(const P& p, const Q& q, const radicand<Z>& d, const R& r, const C& norm,
                                           int scale, rounding mode) {
    detail::leading value = detail::leading_of(norm);
    if (value.significand == 0) {
        return detail::from_bits<T>(0, false);
    }
    detail::leading second = detail::leading_of(q) * d.root;
    second.negative = !second.negative;
    value = value / (detail::leading_of(p) + second);
    value.exponent += scale;
    return detail::round_estimate<T>(value, mode, [&](std::uint64_t m, int exponent) {
        return detail::against_boundary<Z>(p, q, d.value, r, value.negative, scale, m, exponent);
    });
}

} // namespace graze::inline v0_1
