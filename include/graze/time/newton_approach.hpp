// When two centres are at a given distance, as a sum of two doubles with a proven error: one Newton step from a time in
// doubles, with the residual |Δx + Δu t|² - R² from error-free transforms.
//
// u = 2^-53, doubles rounded to nearest. The values that are not error-free are low parts, where a rounding costs u²;
// whether a sum of theirs is contracted or reordered makes no difference to the counts of roundings below, which
// proofs/contact/parts.cpp derives from these steps.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/machine/environment.hpp>
#include <graze/machine/error_free.hpp>
#include <graze/machine/fence.hpp>
#include <graze/machine/lanes.hpp>
#include <graze/shape/ball.hpp>
#include <graze/time/certain_rounding.hpp>

#include <type_traits>
#include <utility>

namespace graze::inline v0_1::detail {

// Δx, with R in a lane of its own, and Δu. Each is exactly value + error with |error| <= u |value|. L: two numbers side
// by side, which are doubles, or packs with a pair of balls in each lane.
template <class L>
struct motion_side_by_side {
    exact_pair<L> x01, xR2, u01, u_2;
};
using lane_motion = motion_side_by_side<lanes>;

// The motion of two balls, from pointers to their numbers.
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline lane_motion lane_motion_of(const T* x_a, const T* x_b, const T* u_a,
                                                                    const T* u_b, const T& r_a, const T& r_b) noexcept {
    const auto at = [](const T* x, int i) { return static_cast<double>(as_stored(x[i])); };
    const auto third = [&](const T* x) { return N == 3 ? at(x, N - 1) : 0.0; };
    lane_motion m;
    m.x01 = two_difference(lanes{at(x_a, 0), at(x_a, 1)}, lanes{at(x_b, 0), at(x_b, 1)});
    m.xR2 = two_difference(lanes{read_alone(at(&r_a, 0)), third(x_a)}, lanes{-read_alone(at(&r_b, 0)), third(x_b)});
    m.u01 = two_difference(lanes{at(u_a, 0), at(u_a, 1)}, lanes{at(u_b, 0), at(u_b, 1)});
    m.u_2 = two_difference(lanes{0, third(u_a)}, lanes{0, third(u_b)});
    return m;
}
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline lane_motion lane_motion_of(const ball<N, T>& a, const ball<N, T>& b) noexcept {
    return lane_motion_of<N>(a.position.component, b.position.component, a.velocity.component, b.velocity.component,
                             a.radius, b.radius);
}

// Δx + Δu t0 in two lanes, with what the next steps need of it.
template <bool Fused, class V = lanes>
struct lane_displacement {
    factor<V, Fused> high; // yh
    V low;                 // yl: y = yh + yl
    factor<V, Fused> du;   // the value of Δu
};

// With m = |Δx| + |Δu| t0 lane by lane, of values: |yl| <= 3.02 u m, and the error of yh + yl is at most 7.01 u² m: the
// exact y is yh + the errors of the sum, the product and Δx + (the error of Δu) t0, which are at most u m, u |Δu| t0, u
// |Δx| and u |Δu| t0; the four roundings in adding them up cost u² (|Δu| t0 + m + (m + |Δu| t0) + (2m + |Δu| t0)).
template <bool Fused, class V>
[[nodiscard, gnu::always_inline]] constexpr inline lane_displacement<Fused, V>
displacement(const exact_pair<V>& dx, const exact_pair<V>& du, const factor<V, Fused>& t0) noexcept {
    const auto speed = as_factor<Fused>(du.value);
    const auto way = two_product(speed, t0);
    const auto sum = two_sum(dx.value, way.value);
    return {as_factor<Fused>(sum.value), sum.error + (way.error + (dx.error + du.error * t0.value)), speed};
}

// |y|² - R², with R in y2's first lane, as a value and a low part in each of two lanes, less the squares of low parts.
template <bool Fused, class V>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<V>
distance_residual(const lane_displacement<Fused, V>& y01, const lane_displacement<Fused, V>& yR2) noexcept {
    const auto square01 = two_square(y01.high);
    const auto squareR2 = two_square(yR2.high);
    const auto low_terms = [](const auto& y, const exact_pair<V>& square) __attribute__((always_inline)) {
        return V(square.error + y.low * (y.high.value + y.high.value));
    };
    const V less_R{-1, 1};
    const auto sum = two_sum(square01.value, V(less_R * squareR2.value));
    return {sum.value, sum.error + (low_terms(y01, square01) + less_R * low_terms(yR2, squareR2))};
}

// One of two numbers side by side, and a condition on it.
template <class L>
using number_of = std::remove_cvref_t<decltype(std::declval<const L&>()[0])>;
template <class L>
using condition_of = std::remove_cvref_t<decltype(std::declval<number_of<L>>() < std::declval<number_of<L>>())>;

// Whether all conditions hold, without a branch for each.
template <class... B>
[[nodiscard, gnu::always_inline]] inline auto hold_together(B... conditions) noexcept {
    if constexpr ((std::is_same_v<B, bool> && ...)) {
        return (static_cast<unsigned>(conditions) & ...) != 0;
    } else {
        return (conditions & ...);
    }
}

// The result of a step from t0; see newton_approach.
template <class L>
struct newton_step {
    number_of<L> t1, error, sensitivity, per_time;
    condition_of<L> good, sharp;
};

// τ = t0 + t1 with an error of at most `error`, if good.
template <bool Fused>
struct newton_approach {
    lane_motion motion;
    factor<lanes, Fused> t0;
    lane_displacement<Fused> y01, yR2; // at t0
    double t1;
    double error;
    double sensitivity; // γ >= (L V/σ)²
    double per_time;    // a/σ: the relative error of σ for an error of the time
    bool good;          // whether the time is known
    bool sharp;         // whether it is close enough for the bounds of a contact

    [[nodiscard]] bounded<double> time() const noexcept { return {t0.value[0], t1, error}; }
};

// The smaller root τ near t0, for D > 0. Let L² = |Δx|² + R², V = |Δu|, y = Δx + Δu t0, f = |y|² - R² and σ = -y·Δu.
// For σ > 0 the smaller root is t0 + δ with δ = (f + V² δ²)/(2σ) and |δ| <= |f|/σ (as D = σ² - V² f > 0). t1 = f/(2σ)
// with computed f and σ. `good` means that V² |t1|/σ < 2^-10, σ > 0 and γ < 2^80, for the computed values, and that L²
// and V² are in ranges where nothing over- or underflows that matters. Then
//   |f| <= 2.003 σ² V^-2 2^-10 <= 2^-8.99 |y|², so |y|² < 1.0022 R²,
//     σ < 1.002 R V <= 0.71 L V (R <= L/√2 when the balls are apart),
//     t0 < 1.43 L/V, and with m as above, |m| <= 2.25 L;
//   |σ̂ - σ| <= 3.01 u |y| V + u (|y| V + 2.25·3.02 L V) <= 10 u L V < 2^-9 σ;
//   the low terms of f add up to at most u (1 + 1 + 2.02 + 2.01) R² + 2.01·3.02 u |m| R <= 18.1 u L R (errors of the
//     squares, of R², of the sums, R's error, and 2 yl yh), with at most 6 roundings each: 109 u² L R; y's error makes
//     2.01 R·7.01 u² |m| <= 32 u² L R; the difference that cancels adds 18 u² L R and, with f's last rounding, 2 u |f|;
//     what is left out, |yl|² and R's error squared, is at most (3.02·2.25)² u² L² + u² R² <= 47 u² L². Together
//     |f̂ - f| <= 163 u² L² + 2 u |f|;
//   V |δ| <= 2.01 V |t1| + 163 u² L² V/σ, of which the last is at most 163 u² γ < 2^-18 of what it comes from, so that
//   |τ - t0 - t1| <= (1.02·163 u² L² + 4.1 V² t1²)/(2σ)·(1 + 2^-9) + |t1| (10.2 u L V/σ + 4 u), where
//     10.2 u L V |t1| <= 5.1 (u² L² + V² t1²):
//     below (89 u² L² + 7.2 V² t1²)/σ + 4 u |t1|, and that, roundings of this and of t1 ± error
//     included, below error := 2^-99 L²/σ + (8 V² |t1|/σ + 2^-48) |t1|.
// So error >= 31 u |t1| and error >= 2^-99.1 t0, on which further bounds rest; these also need γ < 2^40 and |t1| <
// 2^-50 L²/σ (sharp, of which good follows), and then 1 <= 0.51 γ and L V/σ <= 0.715 γ.
//
// In the plane the third components are 0, and so is what they would add.
//
// length2 may be more than L². Then Δx may be off as well, by 8.1 u² of that length: this makes 2.01·0.71·8.1 u² of
// length2 more in f, 175 in place of 163, and error bounds it still.
template <int N = 3, bool Fused, class L>
[[nodiscard, gnu::always_inline]] inline newton_step<L>
step_from(const motion_side_by_side<L>& m, const lane_displacement<Fused, L>& y01,
          const lane_displacement<Fused, L>& yR2, const number_of<L>& length2) noexcept {
    using number = number_of<L>;
    const auto f = distance_residual(y01, yR2);
    const number residual = settled(settled(f.value[0] + f.value[1]) + (f.error[0] + f.error[1]));

    const auto with_third = [](const L& x01, const L& x_2) __attribute__((always_inline)) {
        return N == 3 ? L(x01 + x_2) : x01;
    };
    const L along = with_third(y01.high.value * m.u01.value, yR2.high.value * m.u_2.value);
    const number sigma = -(along[0] + along[1]);
    const L squares = with_third(m.u01.value * m.u01.value, m.u_2.value * m.u_2.value);
    const number speed2 = squares[0] + squares[1];
    const number inverse = 1 / sigma;
    const number t1 = settled(residual * (0.5 * inverse));
    const number per_time = speed2 * inverse;
    const number way = length2 * inverse;
    const number sensitivity = per_time * way;
    const number magnitude = absolute(t1);
    const number least = settled(0x1p-99 * way);
    const number bend = settled(8 * per_time);
    const number error = settled(magnitude * (0x1p-48 + bend * magnitude) + least);
    const auto in_range = hold_together(within_powers<-200, 200>(length2), within_powers<-200, 200>(speed2));
    return {t1,
            error,
            sensitivity,
            per_time,
            hold_together(in_range, sensitivity < 0x1p80, 0x1p10 * (speed2 * magnitude) < sigma),
            hold_together(in_range, sensitivity < 0x1p40, 0x1p50 * magnitude < way)};
}
template <bool Fused, int N = 3>
[[nodiscard, gnu::always_inline]] inline newton_approach<Fused> approach_near(const lane_motion& m, double time,
                                                                              double length2) noexcept {
    newton_approach<Fused> r;
    r.motion = m;
    r.t0 = as_factor<Fused>(both(time));
    r.y01 = displacement(m.x01, m.u01, r.t0);
    r.yR2 = N == 3
                ? displacement(m.xR2, m.u_2, r.t0)
                : lane_displacement<Fused>{as_factor<Fused>(m.xR2.value), m.xR2.error, as_factor<Fused>(m.u_2.value)};
    const auto step = step_from<N>(m, r.y01, r.yR2, length2);
    r.t1 = step.t1;
    r.error = step.error;
    r.sensitivity = step.sensitivity;
    r.per_time = step.per_time;
    r.good = step.good;
    r.sharp = step.sharp;
    return r;
}

// |Δx|² + R².
template <class L>
[[nodiscard, gnu::always_inline]] inline number_of<L> squared_length(const motion_side_by_side<L>& m) noexcept {
    const L x01 = m.x01.value * m.x01.value;
    const L xR2 = m.xR2.value * m.xR2.value;
    const L sum2 = x01 + xR2;
    return sum2[0] + sum2[1];
}
template <bool Fused, int N = 3>
[[nodiscard, gnu::always_inline]] inline newton_approach<Fused> approach_near(const lane_motion& m,
                                                                              double time) noexcept {
    return approach_near<Fused, N>(m, time, squared_length(m));
}

} // namespace graze::inline v0_1::detail
