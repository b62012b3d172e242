// Sums and products with their rounding errors: a + b = s + e and a b = p + e, exactly.
//
// These hold if doubles are rounded once each, to nearest, and nothing overflows. The product also needs |a b| >=
// 2^-969, or a zero, so that its error is a double. V is double, or a compiler's vector of doubles, which is worked on
// lane by lane. Every step is settled, so that neither -fassociative-math nor contraction changes it. The caller
// excludes -ffast-math as a whole, x87 registers and other rounding modes (machine/environment.hpp).
#pragma once

#include <graze/machine/fence.hpp>

#include <type_traits>

namespace graze::inline v0_1 {

// A rounded sum or product and its rounding error.
template <class V>
struct exact_pair {
    V value;
    V error;
};

namespace detail {

#if defined(__FMA__) || defined(__FP_FAST_FMA) || defined(__ARM_FEATURE_FMA)
inline constexpr bool has_fused_multiply_add = true;
#else
inline constexpr bool has_fused_multiply_add = false;
#endif

// x y - p rounded once.
[[nodiscard, gnu::always_inline]] inline double fused_residual(double x, double y, double p) noexcept {
#if defined(__GNUC__)
    return __builtin_fma(x, y, -p);
#else
    return x * y - p; // not reached: has_fused_multiply_add is false
#endif
}
template <class V>
[[nodiscard, gnu::always_inline]] inline V fused_residual(const V& x, const V& y, const V& p) noexcept {
    return V{fused_residual(x[0], y[0], p[0]), fused_residual(x[1], y[1], p[1])};
}

} // namespace detail

// a + b, for any a and b. Knuth's TwoSum (The Art of Computer Programming 2, 4.2.2, Theorem B).
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V> two_sum(V a, V b) noexcept {
    using detail::settled;
    const V s = settled(a + b);
    const V b_part = settled(s - a);
    const V a_part = settled(s - b_part);
    return {s, settled(settled(a - a_part) + settled(b - b_part))};
}

// a - b: the two_sum of a and -b, which is not formed.
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V> two_difference(V a, V b) noexcept {
    using detail::settled;
    const V s = settled(a - b);
    const V b_part = settled(s - a);
    const V a_part = settled(s - b_part);
    return {s, settled(settled(a - a_part) - settled(b + b_part))};
}

// a + b where a = 0 or |a| >= |b|, or a's exponent is at least b's. Dekker's Fast2Sum (1971, Theorem 4.7).
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V> fast_two_sum(V a, V b) noexcept {
    using detail::settled;
    const V s = settled(a + b);
    return {s, settled(b - settled(s - a))};
}

namespace detail {

// Veltkamp's splitting, with 2^27 + 1: x as two parts of at most 26 bits each, high + low = x. Overflows (to a NaN in
// `low`) for |x| >= 2^996.
template <class V>
struct halves {
    V high;
    V low;
};
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline halves<V> veltkamp_split(V x) noexcept {
    const V scaled = settled(x * 0x1.0000002p27);
    const V high = settled(scaled - settled(scaled - x));
    return {high, settled(x - high)};
}

// A factor of several products. Its halves are needed where the products are not Fused.
template <class V, bool Fused = has_fused_multiply_add>
struct factor {
    V value;
    halves<V> parts;
};
template <bool Fused = has_fused_multiply_add, class V>
[[nodiscard, gnu::always_inline]] constexpr inline factor<V, Fused> as_factor(V x) noexcept {
    if (!Fused || std::is_constant_evaluated()) {
        return {x, veltkamp_split(x)};
    }
    return {x, {x, x}};
}

} // namespace detail

// a b: by a fused multiply-add if the machine has it, otherwise by Dekker's product (1971, Theorem 5.13).
template <class V, bool Fused>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V>
two_product(const detail::factor<V, Fused>& a, const detail::factor<V, Fused>& b) noexcept {
    using detail::settled;
    const V p = settled(a.value * b.value);
    if constexpr (Fused) {
        if (!std::is_constant_evaluated()) {
            return {p, settled(detail::fused_residual(a.value, b.value, p))};
        }
    }
    // Each of these is exact in the order given; the products of halves are exact by themselves.
    const auto& x = a.parts;
    const auto& y = b.parts;
    const V rest = settled(p - x.high * y.high);
    const V cross = settled(settled(rest - x.low * y.high) - x.high * y.low);
    return {p, settled(x.low * y.low - cross)};
}
template <class V>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V> two_product(V a, V b) noexcept {
    return two_product(detail::as_factor(a), detail::as_factor(b));
}

// a².
template <class V, bool Fused>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V>
two_square(const detail::factor<V, Fused>& a) noexcept {
    using detail::settled;
    const V p = settled(a.value * a.value);
    if constexpr (Fused) {
        if (!std::is_constant_evaluated()) {
            return {p, settled(detail::fused_residual(a.value, a.value, p))};
        }
    }
    const auto& x = a.parts;
    const V cross = settled(settled(p - x.high * x.high) - (x.high + x.high) * x.low);
    return {p, settled(x.low * x.low - cross)};
}

} // namespace graze::inline v0_1
