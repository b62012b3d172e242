// The one rounding routine: (p + q√d)/r, in which form every time, position, normal and velocity comes, to the nearest
// float or double, downward or upward.
//
// An estimate of 64 bits, with its bound, tells where the value lies among the format's numbers and the middles
// between them, in all cases but a few per cent. There the exact sign of (p - m r) + q√d at the one boundary m in
// question decides, and zero is a tie. Nothing is rounded twice. Integers alone are used and the result is put together
// from bits: no rounding mode, flush-to-zero or compiler flag has a part in it.
#pragma once

#include <graze/number/leading.hpp>
#include <graze/number/rounding.hpp>
#include <graze/number/sqrt_extension.hpp>

#include <algorithm>

namespace graze {

namespace detail {

// What the integers of a surd are converted to for the exact sign, so that few types are compiled: up to 1152 bits
// hold all components of pairs whose inputs fit two limbs, 19456 those of any pair.
inline constexpr int near_surd_width = 1152;
inline constexpr int widest_surd = 19456;

// The largest scale of a value, 2^2098 for times (lengths up to 2^1023 over velocities from 2^-1074 on), over the
// lowest half bit of doubles, 2^-1075; and the reverse, which is less.
inline constexpr int largest_shift = 2098 + 1075 + 1;

template <int W>
struct common_surd {
    sparse_integer<W> p, q, d, r;
};

template <int W, int Bits>
[[nodiscard]] constexpr sparse_integer<W> to_sparse(const sparse_integer<Bits>& x) noexcept {
    return x;
}
// Balanced digits, one more than limbs where the highest one carries.
template <int W, int Bits>
[[nodiscard]] constexpr sparse_integer<W> to_sparse(const integer<Bits>& x) noexcept {
    sparse_integer<W> r;
    std::uint64_t carry = 0;
    for (int i = 0; i <= integer<Bits>::limbs; ++i) {
        const std::uint64_t limb = x.limb(i) + carry;
        carry = limb < carry || (limb >> 63 != 0 && i < integer<Bits>::limbs) ? 1 : 0;
        r.append(i, static_cast<std::int64_t>(limb));
    }
    return r;
}

// The sign of |p + q√d| 2^scale - m r 2^exponent, for p + q√d of the sign given.
template <int W>
[[nodiscard]] constexpr int against_boundary(const common_surd<W>& x, bool negative, int scale, std::uint64_t m,
                                             int exponent) {
    using power = sparse_integer<largest_shift + 56>;
    const int up = scale - exponent;
    const auto unit = power::from_shifted(negative ? -1 : 1, up > 0 ? up : 0);
    const auto boundary = power::from_shifted(static_cast<std::int64_t>(m), up < 0 ? -up : 0);
    return sign_of_root_sum(x.p * unit - x.r * boundary, x.q * unit, x.d);
}

// √d with its estimate, for all components of one pair.
template <class D>
struct radicand {
    D value;
    leading root;

    constexpr explicit radicand(const D& d) noexcept : value(d), root(square_root(leading_of(d))) {}
};

// The error up to which an estimate serves T: with it, a quotient and 4 bits more, no two boundaries of T, which are
// 2^(63 - digits) units apart, come into question.
template <class T>
inline constexpr std::uint64_t largest_error = std::uint64_t{1} << (59 - std::numeric_limits<T>::digits);

// The number in T that x is rounded to, x not 0 and its error at most 4 (largest_error + 4); against(m, e) is the sign
// of |x| - m 2^e.
template <class T, class Against>
[[nodiscard]] constexpr T round_estimate(const leading& x, rounding mode, Against against) {
    constexpr binary_format format = format_of<T>;
    // |x| lies in [low, low + width] 2^exponent, low >= 2^63.
    std::uint64_t low = x.significand - x.error;
    std::uint64_t width = 2 * x.error;
    int exponent = x.exponent;
    if (low >> 63 == 0) {
        low <<= 1;
        width <<= 1;
        --exponent;
    }
    const int unit = std::max(exponent + 63 - format.precision, format.lowest - 1); // of half a last place
    cut_off cut{0, unit, true};
    const int down = unit - exponent;
    if (unit + 1 <= format.highest && down <= 64) {
        const bool whole = down == 64; // below the smallest number, or nearly half of it
        cut.halves = whole ? 0 : low >> down;
        const std::uint64_t rest = whole ? low : low & ((std::uint64_t{1} << down) - 1);
        const std::uint64_t to_next = whole ? 0 - low : (std::uint64_t{1} << down) - rest;
        if (width >= to_next) {
            const int sign = against(cut.halves + 1, unit);
            cut.halves += sign >= 0 ? 1U : 0U;
            cut.more = sign != 0;
        } else if (rest == 0) {
            cut.more = against(cut.halves, unit) != 0;
        }
    }
    return from_bits<T>(rounded_bits(format, cut, x.negative, mode), x.negative);
}

// p + q√d where p and q√d cancel: (p² - q²d)/(p - q√d), the sum of whose denominator does not.
template <int W>
[[nodiscard]] constexpr leading estimate_by_norm(const common_surd<W>& x, leading p, leading root_term) {
    leading norm = leading_of(x.p * x.p - x.q * x.q * x.d);
    norm.negative = norm.negative != p.negative;
    p.negative = root_term.negative = false;
    return norm / (p + root_term);
}

} // namespace detail

// (p + q√d)/r · 2^scale rounded to T: float or double, r > 0, |scale| <= 2098, all of them integers of known width. An
// exact zero gives +0.
template <class T, class P, class Q, class D, class R>
[[nodiscard]] constexpr T round_to(const P& p, const Q& q, const detail::radicand<D>& d, const R& r, int scale,
                                   rounding mode = rounding::nearest) {
    constexpr int needed = std::max({P::bits, Q::bits, D::bits, R::bits});
    constexpr int width = needed <= detail::near_surd_width ? detail::near_surd_width : detail::widest_surd;
    static_assert(needed <= detail::widest_surd);
    const auto common = [&] {
        return detail::common_surd<width>{detail::to_sparse<width>(p), detail::to_sparse<width>(q),
                                          detail::to_sparse<width>(d.value), detail::to_sparse<width>(r)};
    };
    const detail::leading first = detail::leading_of(p);
    const detail::leading second = detail::leading_of(q) * d.root;
    detail::leading value = first + second;
    if (!value.is_within(detail::largest_error<T>)) {
        value = detail::estimate_by_norm(common(), first, second);
    }
    if (value.significand == 0) {
        return detail::from_bits<T>(0, false);
    }
    value = value / detail::leading_of(r);
    value.exponent += scale;
    return detail::round_estimate<T>(value, mode, [&](std::uint64_t m, int exponent) {
        return detail::against_boundary(common(), value.negative, scale, m, exponent);
    });
}

// The same of p/r.
template <class T, class P, class R>
[[nodiscard]] constexpr T round_to(const P& p, const R& r, int scale, rounding mode = rounding::nearest) {
    return round_to<T>(p, P(0), detail::radicand<R>(R(0)), r, scale, mode);
}

} // namespace graze
