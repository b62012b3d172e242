// The steps from the instant of contact to the contact, in lanes of doubles with proven errors.
//
// Errors of low parts are counted as in time/newton_approach.hpp, whose bounds and notation are used; e is its error of
// the time. proofs/contact/parts.cpp derives the counts from these steps.
#pragma once

#include <graze/time/certain_rounding.hpp>
#include <graze/time/mover_approach.hpp>

namespace graze::inline v0_1::detail {

// 1/x of two sums x = value + error: with r = 1 - ih x = 1 - ih value - ih error, 1/x = ih + ih r + ih r²/(1 - r), |r|
// <= 2.01 u. Its relative error is at most u² + 2u² + 2.1u² + 4.1u² <= 9.2 u², and |il| <= 2.02 u ih.
template <bool Fused, class V = lanes>
struct lane_inverse {
    factor<V, Fused> high;
    V low;
};
template <bool Fused, class V>
[[nodiscard, gnu::always_inline]] constexpr inline lane_inverse<Fused, V> inverse_of(const exact_pair<V>& x) noexcept {
    const auto inverse = as_factor<Fused>(settled(1 / x.value));
    const auto product = two_product(inverse, as_factor<Fused>(x.value));
    const V rest = settled(settled(1 - product.value) - product.error) - inverse.value * x.error;
    return {inverse, rest * inverse.value};
}

// x + u (t0 + t1): an error of at most 2^-104 |x| + 1.25 |u| e. The parts that are added up at the end are the errors
// of a product and of a sum, and u t1: three roundings of each, and one for adding the bound, make at most 3u² |x| +
// |u| (6u² t0 + 3u |t1| + e).
template <bool Fused, class V, class S>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V>
position_in_parts(const V& x, const V& u, const factor<V, Fused>& t0, const S& t1) noexcept {
    const auto way = two_product(as_factor<Fused>(u), t0);
    const auto sum = two_sum(x, way.value);
    return {sum.value, (sum.error + way.error) + u * t1};
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded<lanes> bounded_position(const lanes& x, const lanes& u,
                                                                         const newton_approach<Fused>& r) noexcept {
    const auto y = position_in_parts(x, u, r.t0, r.t1);
    return {y.value, y.error, 0x1p-104 * absolute(x) + absolute(u) * (1.25 * r.error) + underflow};
}

// The normal, high + low.
template <bool Fused, class V = lanes>
struct lane_normal {
    factor<V, Fused> high;
    V low;
};

// yl at τ: zl = yl + Δu t1 has an error of at most 10.1 u² |Δx| + 1.21 |Δu| e, and |zl| <= 3.02 u m + |Δu t1|. Times
// (ih, il), with roundings of at most 8.3 u² |yh| ih + 4.2 u |zl| ih and the inverse's 9.2 u² |yh| ih: together, the
// rounding in adding the bound included, at most (50 u² |Δx| + 1.87 |Δu| e)/R, which is less than 2.5 e a/σ since L <=
// 2^98.5 V e and V/R <= 1.003 a/σ.
template <bool Fused, class V, class S>
[[nodiscard, gnu::always_inline]] constexpr inline V low_at_contact(const lane_displacement<Fused, V>& y,
                                                                    const S& t1) noexcept {
    return y.low + y.du.value * t1;
}
template <bool Fused, class V>
[[nodiscard, gnu::always_inline]] constexpr inline lane_normal<Fused, V>
normal_of(const lane_displacement<Fused, V>& y, const V& low, const factor<V, Fused>& inverse,
          const V& inverse_low) noexcept {
    const auto product = two_product(y.high, inverse);
    return {as_factor<Fused>(product.value), (product.error + y.high.value * inverse_low) + low * inverse.value};
}

// u + φ n: an error of at most |φ| (1.6 error of n + |n| (the relative error of φ + 94 u²)) + 2u² |u|, if the low part
// of φ is at most 9 u |φ|.
// own_error is that without the last term.
template <bool Fused, class V>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V>
velocity_in_parts(const V& u, const factor<V, Fused>& phi, const V& phi_low, const lane_normal<Fused, V>& n) noexcept {
    const auto product = two_product(phi, n.high);
    const auto sum = two_sum(u, product.value);
    return {sum.value, sum.error + (product.error + (phi.value * n.low + phi_low * n.high.value))};
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline bounded<lanes>
bounded_velocity(const lanes& u, const factor<lanes, Fused>& phi, const lanes& phi_low, const lane_normal<Fused>& n,
                 const lanes& own_error) noexcept {
    const auto v = velocity_in_parts(u, phi, phi_low, n);
    return {v.value, v.error, 0x1p-105 * absolute(u) + own_error};
}

// (x.value + x.error)(high + low) without the product of the low parts. For |x.error| <= λ |x.value| and |low| <= 2.02
// u |high| its relative error is at most 8.1 u² + 4.1 u λ more than its factors', and its low part is at most λ + 3.1 u
// of it.
template <bool Fused, class S>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<S>
times(const exact_pair<S>& x, const factor<S, Fused>& high, const S& low) noexcept {
    const auto product = two_product(as_factor<Fused>(x.value), high);
    return {product.value, (product.error + x.value * low) + x.error * high.value};
}

// s = -y·Δu, its low part at most u of it; y01 and y2 with the low parts given, lane 1 of y2 alone. Three products and
// two sums without error; the low terms add up to at most u (4.1 R V + 6.8 L V) + V² |t1|, with 6 roundings each; y's
// own error makes 10.1 u² L V + 1.21 V² e. Together 76 u² L V + 1.5 V² e, relatively at most 54 u² γ + 1.5 e a/σ.
template <bool Fused, class V, class M>
[[nodiscard, gnu::always_inline]] constexpr inline auto
closing_speed(const lane_displacement<Fused, V>& y01, const V& low01, const lane_displacement<Fused, V>& y2,
              const V& low2, const M& m) noexcept {
    const auto product01 = two_product(y01.high, y01.du);
    const auto product2 = two_product(y2.high, y2.du);
    const V rest01 = product01.error + (y01.high.value * m.u01.error + low01 * y01.du.value);
    const V rest2 = product2.error + (y2.high.value * m.u_2.error + low2 * y2.du.value);
    const auto plane_sum = two_sum(product01.value[0], product01.value[1]);
    const auto sum = two_sum(plane_sum.value, product2.value[1]);
    const auto low = (plane_sum.error + sum.error) + ((rest01[0] + rest01[1]) + rest2[1]);
    return fast_two_sum(-sum.value, -settled(low));
}

// Lanes of x in another order, and one of them alone.
[[nodiscard, gnu::always_inline]] inline lanes picked(const lanes& x, int first, int second) noexcept {
    return lanes{x[first], x[second]};
}
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline factor<lanes, Fused> picked(const factor<lanes, Fused>& x, int first,
                                                                     int second) noexcept {
    return {picked(x.value, first, second), {picked(x.parts.high, first, second), picked(x.parts.low, first, second)}};
}

template <bool Fused>
[[nodiscard, gnu::always_inline]] inline factor<double, Fused> picked(const factor<lanes, Fused>& x, int i) noexcept {
    return {x.value[i], {x.parts.high[i], x.parts.low[i]}};
}

template <int N, class T>
[[nodiscard, gnu::always_inline]] inline lanes last_two(const vec<N, T>& x, const vec<N, T>& y) noexcept {
    return lanes{static_cast<double>(as_stored(x[N - 1])), static_cast<double>(as_stored(y[N - 1]))};
}

} // namespace graze::inline v0_1::detail
