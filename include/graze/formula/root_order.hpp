// Which of two smaller roots is first, and whether one is before a given time, by signs of polynomials in the
// coefficients: no square root, no division, no discriminant of either.
#pragma once

#include <graze/formula/quadratic.hpp>

namespace graze::inline v0_1 {

// The sign of t₁ - t₂ for the smaller roots of a_i t² + 2 h_i t + c_i with a_i > 0, h_i < 0 and real roots; exact in an
// exact type. Each quadratic may be multiplied by a positive factor of its own; both need the same unit of time.
//
// With J = a₁h₂ - a₂h₁, G = a₁c₂ - a₂c₁ and K = h₁c₂ - h₂c₁, the resultant of the two is proportional to Res = G² -
// 4JK. If J = 0, the parabolas, scaled to one leading coefficient, have a common axis, and the lower one has the
// earlier root. If Res < 0, the roots interlace. The order is then that of the axes, -h₁/a₁ against -h₂/a₂, whose sign
// is that of J. Otherwise exchange the two if necessary, so that J < 0: the first axis is the earlier one. Let A = a₁G
// - 2 J h₁. It is a₁² times the second quadratic less a₁ a₂ times the first, both at the first one's axis. If A > 0,
// the first one's smaller root comes first; if A < 0, it lies beyond the second's.
struct root_order {
    template <class A, class H, class C, class B, class I, class E>
    [[nodiscard]] constexpr int operator()(const quadratic<A, H, C>& x, const quadratic<B, I, E>& y) const {
        const auto J = x.a * y.h - y.a * x.h;
        const auto G = x.a * y.c - y.a * x.c;
        const int sign_j = graze::sign(J);
        if (sign_j == 0) {
            return -graze::sign(G);
        }
        const auto K = x.h * y.c - y.h * x.c;
        int resultant = 1; // free of charge when JK < 0
        if (sign_j * graze::sign(K) >= 0) {
            resultant = graze::sign(G * G - graze::twice(graze::twice(J * K)));
            if (resultant < 0) {
                return sign_j;
            }
        }
        // A, for the pair in the order in which J < 0: exchanging the two changes the signs of J and G.
        const int side =
            sign_j < 0 ? graze::sign(x.a * G - graze::twice(J * x.h)) : -graze::sign(y.a * G - graze::twice(J * y.h));
        if (side > 0) {
            return sign_j;
        }
        if (side < 0) {
            return resultant == 0 ? 0 : -sign_j;
        }
        return resultant > 0 ? sign_j : 0;
    }
};

// The sign of τ - m for the smaller root τ of a t² + 2 h t + c, from the signs of the quadratic and of its slope at m.
[[nodiscard]] constexpr int root_against(int sign_of_value, int sign_of_slope) {
    return sign_of_value > 0 && sign_of_slope < 0 ? 1 : sign_of_value == 0 && sign_of_slope <= 0 ? 0 : -1;
}

// The quadratic and half its slope, a m² + 2 h m + c and a m + h, at m = numerator/denominator with denominator > 0;
// multiplied by denominator² and by denominator.
struct value_at {
    template <class A, class H, class C, class M, class D>
    [[nodiscard]] constexpr auto operator()(const quadratic<A, H, C>& q, const M& numerator,
                                            const D& denominator) const {
        return q.a * (numerator * numerator) + graze::twice(q.h * (numerator * denominator)) +
               q.c * (denominator * denominator);
    }
};
struct slope_at {
    template <class A, class H, class C, class M, class D>
    [[nodiscard]] constexpr auto operator()(const quadratic<A, H, C>& q, const M& numerator,
                                            const D& denominator) const {
        return q.a * numerator + q.h * denominator;
    }
};

} // namespace graze::inline v0_1
