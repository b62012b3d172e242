// When two movers from far away meet, if they do: from about where they are closest, in doubles.
#pragma once

#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/predicate/refined_balls.hpp>
#include <graze/time/enclosure.hpp>
#include <graze/time/mover_approach.hpp>

namespace graze::inline v0_1::detail {

// The encounter, or `undecided`; for a hit τ = t0 + t1 with an error of at most `error`.
struct decided_approach {
    int what = undecided;
    double t0 = 0, t1 = 0, error = 0;

    [[nodiscard]] constexpr bool is_hit() const noexcept { return what == static_cast<int>(encounter::hit); }
    [[nodiscard]] constexpr bounded<double> time() const noexcept { return {t0, t1, error}; }
};

// Whether this pays: nearer movers need more of a double than what is left of it in t1.
[[nodiscard]] constexpr bool is_distant(double R, double length2) noexcept { return 0x1p24 * (R * R) < length2; }

// At t0 = -h/a in doubles two movers are about where they are closest. There y = Δx + Δu t0 is known to about u² of the
// length, and the other numbers are of the size of R, so that what doubles lose hardly matters beside t0:
//   t1 = -(h0 + √D)/a with h0 = y·Δu, D = a Q + h0² and Q = R² - |y|².
//
// u = 2^-53; as in newton_approach.hpp but for their own V = |Δu|, ε and P. Let L² be length2, P = R² + |y|² and ε =
// 2^-101.5 L. t0 <= 1.01 L/V, as |h| <= L V. So the sizes m of Δx and Δu t0 are at most 2.02 L, and y = yh + yl is off
// by at most 7.01 u² m, for flights 8.1 u² L more: by ε. As doubles y is off by u |y| + ε, and Δu and R by u of them.
// With the roundings of the sums and products
//   a is off by 5.1 u a, its inverse by 6.2 u of it;
//   Q by u (3.1 R² + 5.2 |y|² + |Q|) + 2.1 ε |y| + 2 ε², where |Q| <= P;
//   h0 by 5.2 u |y| V + 1.01 ε V, where |h0| <= 1.01 |y| V;
//   D by a (8.1 u |Q| + u (3.1 R² + 18 |y|²) + 4.4 ε |y| + 4 ε²) <= a (26.1 u P + 4.5 ε √P + 4 ε²).
// ε √P <= u P + ε²/(4u), so D is off by at most a E, E = 36 u P + 2^-149 L², and its sign is certain where |D| > a E.
// For D > a E, G = a E/√D bounds what √D is off by. As √D <= 1.01 V √P, G >= 35 u V √P, and as E >= 12·2^-101 L √P, G
// >= 16 ε V. So h0 is off by 0.22 G; the root, the sum and the product take 0.06 G, and the inverse 0.43 G: t1 is off
// by 1.8 E/√D, t1 ± error rounded.
//
// The way is long: a t0² > 2^10 P. Of a certain sign, |D| <= 1.02 a P makes E <= 1.02 P and ε < 2^-26 √P, so that |h0|
// <= 1.04 V √P and |t1| <= 2.5 √P/V: h = h0 - a t0 < 0 and t0 + t1 > 0. Then c > 0, since D < 0, or since both roots
// are positive. A mode that reads or writes subnormals as zeros takes far less than E.
template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline decided_approach approach_from_afar(const lane_motion& m,
                                                                             double length2) noexcept {
    const auto dot =
        [](const lanes& x01, const lanes& x_2, const lanes& y01, const lanes& y_2) __attribute__((always_inline)) {
        const lanes products = x01 * y01;
        return N == 2 ? products[0] + products[1] : products[0] + products[1] + x_2[1] * y_2[1];
    };
    const double a = dot(m.u01.value, m.u_2.value, m.u01.value, m.u_2.value);
    const double inverse = 1 / a;
    const double t0 = settled(-dot(m.x01.value, m.xR2.value, m.u01.value, m.u_2.value) * inverse);

    const auto near01 = displacement(m.x01, m.u01, as_factor<Fused>(both(t0)));
    const auto near_2 = N == 3 ? displacement(m.xR2, m.u_2, as_factor<Fused>(both(t0))) : lane_displacement<Fused>{};
    const lanes y01 = near01.high.value + near01.low;
    const lanes y_2 = near_2.high.value + near_2.low;
    const double h0 = dot(y01, y_2, m.u01.value, m.u_2.value);
    const double distance2 = dot(y01, y_2, y01, y_2);
    const double R2 = m.xR2.value[0] * m.xR2.value[0];
    const double P = R2 + distance2;
    const double D = discriminant_halved{}(quadratic<double, double, double>{a, h0, distance2 - R2});
    const double E = 0x1.2p-48 * P + 0x1p-149 * length2;
    decided_approach r;
    if (!hold_together(within_powers<-200, 200>(length2), within_powers<-200, 200>(a), std::fabs(D) > a * E, t0 > 0,
                       a * (t0 * t0) > 0x1p10 * P)) {
        return r;
    }
    if (D < 0) {
        r.what = static_cast<int>(encounter::miss);
        return r;
    }
    const double root = plain_sqrt(D);
    r.what = static_cast<int>(encounter::hit);
    r.t0 = t0;
    r.t1 = settled(-(h0 + root) * inverse);
    r.error = 2 * E * inverse_or_more(root);
    return r;
}

// For two movers of which |Δx| is most of the length.
template <moving B>
struct distant_movers {
    const B *a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] decided_approach operator()(std::bool_constant<Fused>) const noexcept {
        const lane_movers m = lane_movers_of<Fused>(*a, *b);
        return approach_from_afar<Fused, dimension_of<B>>(m.motion, m.length2);
    }
};

} // namespace graze::inline v0_1::detail
