// The times at which two things are at a given distance: a t² + 2 h t + c = 0, Eqs. (10) and (11) with h = b/2.
#pragma once

#include <graze/formula/relative_motion.hpp>

namespace graze::inline v0_1 {

// Units: a velocity², h length·velocity, c length². If h < 0 and c >= 0, the smaller root is the time of the collision.
template <class A, class H, class C>
struct quadratic {
    A a;
    H h;
    C c;
};
template <class A, class H, class C>
quadratic(A, H, C) -> quadratic<A, H, C>;

// The three coefficients of (11), each as a function object, so that a decision computes only those that it needs.
struct coefficient_a {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(m.du);
    }
};
struct coefficient_h {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::dot(m.dx, m.du);
    }
};
struct coefficient_c {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(m.dx) - m.R * m.R;
    }
};

// Always inlined, as relative_motion_between is: in doubles a call would cost more than the work.
template <int N, class X, class U, class S>
[[nodiscard, gnu::always_inline]] constexpr inline auto quadratic_of(const relative_motion<N, X, U, S>& m) {
    return quadratic{coefficient_a{}(m), coefficient_h{}(m), coefficient_c{}(m)};
}

} // namespace graze::inline v0_1
