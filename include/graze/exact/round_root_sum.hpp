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
struct root_sum_integers {
    using type = I;
};
template <int Bits>
struct root_sum_integers<integer<Bits>> {
    static_assert(Bits <= 128);
    using type = integer<Bits <= 64 ? 576 : 1152>;
};

} // namespace detail

// The integer type of p, q, d and r if a pair's lengths and velocities are of type I. Their formulas have up to nine
// factors (an edge's velocities). One type for all of them keeps programs small.
template <class I>
using root_sum_integer = typename detail::root_sum_integers<I>::type;

namespace detail {

// The largest quotient, in bits, between the scales of a value and a boundary. A boundary's exponent is in [-1075,
// 971]. Times have scales up to 2^2098 (lengths up to 2^1023 over velocities from 2^-1074 on); lengths of flights have
// scales down to 2^-3119.
inline constexpr int largest_shift = 3119 + 971;

[[nodiscard]] constexpr workspace* room_of(const big_integer& x, const big_integer& y, const big_integer& z) noexcept {
    return x.room() != nullptr ? x.room() : y.room() != nullptr ? y.room() : z.room();
}

// The sign of |p + q√d| 2^scale - m r 2^exponent, given the sign of p + q√d.
[[nodiscard, gnu::noinline]] constexpr int against_boundary(const big_integer& p, const big_integer& q,
                                                            const big_integer& d, const big_integer& r, bool negative,
                                                            int scale, std::uint64_t m, int exponent) {
    workspace* const room = room_of(p, q, r);
    const workspace::scope scope(room);
    const int up = scale - exponent;
    const auto unit = big_integer::from_shifted(*room, negative ? -1 : 1, up > 0 ? up : 0);
    const auto boundary = big_integer::from_shifted(*room, static_cast<std::int64_t>(m), up < 0 ? -up : 0);
    return sign_of_root_sum(p * unit - r * boundary, q * unit, d);
}

// p + q√d where p and q√d cancel: (p² - q²d)/(p - q√d), whose denominator does not cancel.
[[nodiscard, gnu::noinline]] constexpr leading estimate_by_norm(const big_integer& p, const big_integer& q,
                                                                const big_integer& d, leading first, leading second) {
    const workspace::scope scope(room_of(p, q, d));
    leading norm = leading_of(p * p - q * q * d);
    norm.negative = norm.negative != first.negative;
    first.negative = second.negative = false;
    return norm / (first + second);
}

// (p + q√d)/r · 2^scale rounded, even if the leading bits leave it open.
template <class T>
[[nodiscard, gnu::noinline]] constexpr T round_by_sign(const big_integer& p, const big_integer& q, const big_integer& d,
                                                       const leading& root, const big_integer& r, int scale,
                                                       rounding mode) {
    const leading first = leading_of(p);
    const leading second = leading_of(q) * root;
    leading value = first + second;
    if (!value.is_within(largest_error<T>)) {
        value = estimate_by_norm(p, q, d, first, second);
    }
    if (value.significand == 0) {
        return from_bits<T>(0, false);
    }
    value = value / leading_of(r);
    value.exponent += scale;
    return round_estimate<T>(value, mode, [&](std::uint64_t m, int exponent) {
        return against_boundary(p, q, d, r, value.negative, scale, m, exponent);
    });
}

// Both for integers whose width is in their type.
inline constexpr int root_sum_room = 2048;
template <int Bits>
[[nodiscard, gnu::noinline]] constexpr int against_boundary(const integer<Bits>& p, const integer<Bits>& q,
                                                            const integer<Bits>& d, const integer<Bits>& r,
                                                            bool negative, int scale, std::uint64_t m, int exponent) {
    static_assert(Bits <= 1152);
    workspace_of<root_sum_room> room;
    return against_boundary(to_big(room, p), to_big(room, q), to_big(room, d), to_big(room, r), negative, scale, m,
                            exponent);
}
template <class T, int Bits>
[[nodiscard, gnu::noinline]] constexpr T round_by_sign(const integer<Bits>& p, const integer<Bits>& q,
                                                       const integer<Bits>& d, const leading& root,
                                                       const integer<Bits>& r, int scale, rounding mode) {
    static_assert(Bits <= 1152);
    workspace_of<root_sum_room> room;
    return round_by_sign<T>(to_big(room, p), to_big(room, q), to_big(room, d), root, to_big(room, r), scale, mode);
}

} // namespace detail

// d >= 0 with an estimate of its root, shared by all numbers of one Q(√d). Z is a root_sum_integer.
template <class Z>
struct radicand {
    Z value;
    detail::leading root;

    constexpr radicand() noexcept : value(0) {} // for rational numbers
    constexpr explicit radicand(const Z& d) noexcept : value(d), root(detail::square_root(detail::leading_of(value))) {}
};

// (p + q√d)/r · 2^scale rounded to T: float or double, r > 0, -3119 <= scale <= 2098; p, q and r of any width up to
// Z's. An exact zero gives +0.
template <class T, class P, class Q, class Z, class R>
[[nodiscard]] constexpr T round_to(const P& p, const Q& q, const radicand<Z>& d, const R& r, int scale,
                                   rounding mode = rounding::nearest) {
    if (const auto certain = detail::round_leading<T>(detail::leading_of(p), detail::leading_of(q), d.root,
                                                      detail::leading_of(r), scale, mode)) {
        return *certain;
    }
    return detail::round_by_sign<T>(Z(p), Z(q), d.value, d.root, Z(r), scale, mode);
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
        return detail::against_boundary(Z(p), Z(q), d.value, Z(r), value.negative, scale, m, exponent);
    });
}

} // namespace graze::inline v0_1
