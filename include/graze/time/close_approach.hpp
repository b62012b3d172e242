// When two balls that nearly touch meet: by where they start, from a distance in three times a double's precision.
#pragma once

#include <graze/machine/fused.hpp>
#include <graze/time/distant_approach.hpp>

namespace graze::inline v0_1::detail {

// c = |Δx|² - R²: high + low.
//
// u = 2^-53. Let S = |Δx|² + R². The squares of values are summed with all errors kept. Of the first order are the
// errors of the squares (u S in all), the products of high and low parts (2 u S) and the errors of the sums (2 u S).
// They are summed with their errors kept, at most u times (1 + 2 + 3 + 4 + 4 + 5) u S. These, the errors of the
// products (2 u² S) and the squares of low parts (u² S), 22 u² S in all, take at most 10 roundings each: with the last
// sum below 2^-150 S + 2^-105 |c|.
template <bool Fused>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<double>
distance_in_parts(const exact_pair<lanes>& x01, const exact_pair<lanes>& xR2) noexcept {
    const lanes less_R{-1, 1};
    const auto high01 = as_factor<Fused>(x01.value);
    const auto highR2 = as_factor<Fused>(xR2.value);
    const auto square01 = two_square(high01);
    const auto squareR2 = two_square(highR2);
    const auto cross01 = two_product(high01, as_factor<Fused>(lanes(x01.error + x01.error)));
    const auto crossR2 = two_product(highR2, as_factor<Fused>(lanes(xR2.error + xR2.error)));

    const auto lane_sums = two_sum(square01.value, lanes(less_R * squareR2.value));
    const auto sum = two_sum(lane_sums.value[0], lane_sums.value[1]);

    const auto errors = two_sum(square01.error, lanes(less_R * squareR2.error));
    const auto crosses = two_sum(cross01.value, lanes(less_R * crossR2.value));
    const auto both_kinds = two_sum(errors.value, crosses.value);
    const auto with_sums = two_sum(both_kinds.value, lane_sums.error);
    const auto middle = two_sum(with_sums.value[0], with_sums.value[1]);
    const auto middle_sum = two_sum(middle.value, sum.error);

    const lanes rest = ((errors.error + crosses.error) + (both_kinds.error + with_sums.error)) +
                       ((cross01.error + x01.error * x01.error) + less_R * (crossR2.error + xR2.error * xR2.error));
    const auto c = two_sum(sum.value, middle_sum.value);
    return {c.value, settled(c.error + ((middle.error + middle_sum.error) + (rest[0] + rest[1])))};
}

// -h = -Δx·Δu: high + low. Products and sums of values are exact; the low terms, 5 u |Δx||Δu|, take at most 6 roundings
// each, and the products of low parts, u² |Δx||Δu|, are left out: 31 u² |Δx||Δu|.
template <bool Fused>
[[nodiscard, gnu::always_inline]] constexpr inline exact_pair<double> closing_in_parts(const lane_motion& m) noexcept {
    const auto product01 = two_product(as_factor<Fused>(m.x01.value), as_factor<Fused>(m.u01.value));
    const auto product_2 = two_product(as_factor<Fused>(m.xR2.value), as_factor<Fused>(m.u_2.value));
    const lanes rest01 = product01.error + (m.x01.value * m.u01.error + m.x01.error * m.u01.value);
    const lanes rest_2 = product_2.error + (m.xR2.value * m.u_2.error + m.xR2.error * m.u_2.value);
    const auto plane_sum = two_sum(product01.value[0], product01.value[1]);
    const auto sum = two_sum(plane_sum.value, product_2.value[1]);
    return {-sum.value, -settled((plane_sum.error + sum.error) + ((rest01[0] + rest01[1]) + rest_2[1]))};
}

// With g = -h and z = a c/g², τ = c/(2g) (1 + z/4 + z²/8 + ...), whose next term is below 2^-81 for z < 2^-26. Let s =
// a L²/g², L² = length2; L |Δu|/g <= s, as it is at least 1. For s < 2^20 g is off by 31 u² s of it, g's low part is at
// most 2^-40.6 g; for |c| > 2^-60 L² c's is at most 2^-41 |c|. So the quotient of the high parts is off by 2^-39.5 of
// it; what corrects it takes five roundings and leaves out the product of two such parts: 2^-78. z is right to 2^-38.5
// of it, as a is to 5.1 u.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline decided_approach approach_from_near(const lane_motion& m,
                                                                             double length2) noexcept {
    const auto c = distance_in_parts<Fused>(m.x01, m.xR2);
    const auto g = closing_in_parts<Fused>(m);
    const lanes squares = m.u01.value * m.u01.value + m.u_2.value * m.u_2.value;
    const double a = squares[0] + squares[1];
    const double inverse = 0.5 / g.value;
    const double t0 = settled(c.value * inverse);
    const double turn = 4 * (a * inverse);
    const double z = turn * t0;
    const double s = turn * (inverse * length2);
    decided_approach r;
    const double gap = std::fabs(c.value);
    if (!hold_together(within_powers<-200, 200>(length2), within_powers<-200, 200>(a), g.value > 0,
                       gap > 0x1p-60 * length2, std::fabs(z) < 0x1p-26, s < 0x1p20)) {
        return r;
    }
    if (c.value < 0) {
        r.what = static_cast<int>(encounter::overlap);
        return r;
    }
    const auto back = two_product(as_factor<Fused>(t0), as_factor<Fused>(g.value + g.value));
    const double residual = settled(settled(c.value - back.value) - back.error) + (c.error - t0 * (g.error + g.error));
    r.what = static_cast<int>(encounter::hit);
    r.t0 = t0;
    r.t1 = settled(residual * inverse + t0 * (z * (0.25 + 0.125 * z)));
    r.error = 0x1p-149 * (length2 * inverse) + t0 * (0x1p-77 + (0x1p-100 * s + 0x1p-40 * z));
    return r;
}

// Whether this pays, by the square of the way up to a time: on longer ways a step from there is good enough.
[[nodiscard]] constexpr bool is_close(double way2, double length2) noexcept { return way2 < 0x1p-76 * length2; }

template <int N>
struct close_balls {
    const ball<N, double>*a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] decided_approach operator()(std::bool_constant<Fused>) const noexcept {
        const lane_motion m = lane_motion_of(*a, *b);
        return approach_from_near<Fused>(m, squared_length(m));
    }
};

} // namespace graze::inline v0_1::detail
