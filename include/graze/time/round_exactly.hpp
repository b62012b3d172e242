// Exact times, rounded once.
#pragma once

#include <graze/exact/round_root_sum.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/time/certain_rounding.hpp>
#include <graze/time/exact_event.hpp>

namespace graze::inline v0_1::detail {

// The integers that make up the numbers p + q√d of a lifted motion.
template <class M>
[[nodiscard]] constexpr auto root_sum_integer_of(const M& m) noexcept {
    if constexpr (requires { m.R; }) {
        return root_sum_integer<std::remove_cvref_t<decltype(m.R)>>();
    } else {
        return root_sum_integer<std::remove_cvref_t<decltype(m.r)>>();
    }
}
template <class M>
using root_sum_integer_for = decltype(root_sum_integer_of(std::declval<M>()));

// The smaller root (-h - √D)/a of a quadratic with a > 0, in units of 2^unit.
template <class T, class Z, class A, class H, class From = from_now>
[[nodiscard]] constexpr T round_root(const A& a, const H& h, const radicand<Z>& discriminant, int unit,
                                     rounding mode = rounding::nearest, const From& counted = {}) {
    return round_to<T>(counted(-h, a), Z(-1), discriminant, a, unit, mode);
}

// The same for h < 0 and c >= 0, as c/(-h + √D).
template <class T, class Z, class Q>
[[nodiscard]] constexpr T round_root_from_now(const Q& q, const radicand<Z>& discriminant, int unit,
                                              rounding mode = rounding::nearest) {
    return round_to_by_norm<T>(-q.h, Z(-1), discriminant, q.a, q.c, unit, mode);
}

// When an approaching ball touches a plane, (33) completed: (|w·n| - r √(n·n))/|u·n|.
template <class T, class Z, class M, class From = from_now>
[[nodiscard]] constexpr T round_plane_time(const M& m, const radicand<Z>& normal, int unit,
                                           rounding mode = rounding::nearest, const From& counted = {}) {
    const auto height = plane_height{}(m);
    const auto other = plane_speed{}(m); // of the opposite sign
    const bool below = graze::sign(height) < 0;
    const auto speed = below ? other : -other;
    return round_to<T>(counted(below ? -height : height, speed), -m.r, normal, speed, unit, mode);
}

// The time of an event after its start.
template <class T>
[[nodiscard, gnu::noinline]] constexpr T round_exactly(const exact_root& r, rounding mode) {
    const big_quadratic& q = r.from_start;
    const radicand<big_integer> d(discriminant_halved{}(q));
    return r.start.sign() == 0 ? round_root_from_now<T>(q, d, r.unit, mode)
                               : round_root<T>(q.a, q.h, d, r.unit, mode, from_earlier<big_integer>{r.start});
}

// The same in integers of one limb, for balls whose inputs fit; none for others.
template <class T, int N, class U>
[[nodiscard]] constexpr certain_number<T> round_narrow(const event_row<N, U>& e, rounding mode) {
    using P = two_balls<N>;
    if (const auto in = lift_row<P>(e.row); e.is_of_balls() && in.width() <= short_integer::bits) {
        const auto q = short_quadratic<P>(in);
        using Z = root_sum_integer<short_integer>;
        return {round_root_from_now<T>(q, radicand<Z>(discriminant_halved{}(q)), unit_of(in), mode), true};
    }
    return {};
}

} // namespace graze::inline v0_1::detail
