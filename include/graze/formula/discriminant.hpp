// The discriminant of Eq. (12), with the parentheses that the source omits, in four forms. They are equal in exact
// arithmetic and lose different things in any other.
#pragma once

#include <graze/formula/quadratic.hpp>

namespace graze::inline v0_1 {

// The forms. textbook: b² - 4ac as in (11) and (12), which is 4D. halved: D = h² - ac. kahan: the same, with its
// rounding error recovered by fused multiply-adds. lagrange: D = R²|Δu|² - |Δx × Δu|².
enum class variant { textbook, halved, kahan, lagrange };

struct discriminant_textbook { // 4D
    template <class A, class H, class C>
    [[nodiscard]] constexpr auto operator()(const quadratic<A, H, C>& q) const {
        const auto b = graze::twice(q.h);
        return b * b - graze::twice(graze::twice(q.a * q.c));
    }
};

struct discriminant_halved {
    template <class A, class H, class C>
    [[nodiscard]] constexpr auto operator()(const quadratic<A, H, C>& q) const {
        return q.h * q.h - q.a * q.c;
    }
};

// h² - ac to 1.5 units in the last place, for the given a, h and c (Jeannerod, Louvet, Muller 2013). It corrects the
// last subtraction, not the errors that a, h and c already have.
struct discriminant_kahan {
    template <has_fma T>
    [[nodiscard]] constexpr T operator()(const quadratic<T, T, T>& q) const {
        using traits = number_traits<T>;
        const T ac = q.a * q.c;
        const T error = traits::fma(-q.a, q.c, ac);
        return traits::fma(q.h, q.h, -ac) + error;
    }
};

// By Lagrange's identity, from R, a = |Δu|² and Δx × Δu. No length is subtracted from a length, so distant and grazing
// balls lose far less.
struct discriminant_of_cross {
    template <class S, class A, class X>
    [[nodiscard]] constexpr auto operator()(const S& R, const A& a, const X& cross) const {
        return R * R * a - graze::squared_norm(cross);
    }
};
struct discriminant_lagrange {
    template <int N, class X, class U, class S>
    [[nodiscard]] constexpr auto operator()(const relative_motion<N, X, U, S>& m) const {
        return discriminant_of_cross{}(m.R, graze::squared_norm(m.du), graze::cross(m.dx, m.du));
    }
};

// Whether number type T can run variant V: Kahan's needs a fused multiply-add.
template <variant V, class T>
inline constexpr bool has_variant = number<T>;
template <class T>
inline constexpr bool has_variant<variant::kahan, T> = has_fma<T>;

} // namespace graze::inline v0_1
