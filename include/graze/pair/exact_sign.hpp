// The sign of any formula of an exact motion; where its integers are wide, an estimate's sign if that is certain.
#pragma once

#include <graze/exact/estimate.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/relative_motion.hpp>

#include <array>

namespace graze::inline v0_1::detail {

// Whether a motion's numbers are so long that a formula in estimates is cheap beside the formula itself. Integers whose
// width is in their type are short.
template <int N>
[[nodiscard]] constexpr bool is_long(const vec<N, big_integer>& x) noexcept {
    constexpr int few = 3;
    return x[0].count() > few || x[1].count() > few || x[N - 1].count() > few;
}
template <int N>
[[nodiscard]] constexpr bool is_long(const relative_motion<N, big_integer, big_integer, big_integer>& m) noexcept {
    return is_long(m.dx) || is_long(m.du);
}
template <int N, class R>
[[nodiscard]] constexpr bool is_long(const plane_motion<N, big_integer, big_integer, big_integer, R>& m) noexcept {
    return is_long(m.w) || is_long(m.u) || is_long(m.n);
}

template <int N, class T>
[[nodiscard]] constexpr vec<N, estimate> estimated(const vec<N, T>& x) noexcept {
    return make_vec<N>([&](int i) { return estimate_of(x[i]); });
}
template <int N, class X, class U, class S>
[[nodiscard]] constexpr auto estimated(const relative_motion<N, X, U, S>& m) noexcept {
    return relative_motion{estimated(m.dx), estimated(m.du), estimate_of(m.R)};
}
template <int N, class X, class U, class E, class S>
[[nodiscard]] constexpr auto estimated(const plane_motion<N, X, U, E, S>& m) noexcept {
    return plane_motion{estimated(m.w), estimated(m.u), estimated(m.n), estimate_of(m.r)};
}

// The exact sign of f(m). instead(e), with e the motion in estimates, is the same number, perhaps in a form that
// cancels less.
template <class M, class F, class G>
[[nodiscard]] constexpr int exact_sign(const M& m, F f, G instead) {
    if constexpr (requires { is_long(m); }) {
        if (is_long(m)) {
            if (const estimate e = instead(estimated(m)); is_certain(e)) {
                return e.value < 0 ? -1 : 1;
            }
        }
    }
    return sign(f(m));
}
template <class M, class F>
[[nodiscard]] constexpr int exact_sign(const M& m, F f) {
    return exact_sign(m, f, f);
}

} // namespace graze::inline v0_1::detail
