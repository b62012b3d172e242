// An event's exact time, rounded.
#pragma once

#include <graze/exact/round_root_sum.hpp>
#include <graze/time/enclosure.hpp>
#include <graze/time/exact_event.hpp>
#include <graze/time/further_time.hpp>
#include <graze/time/round_in_doubles.hpp>

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

// The same for the distance of two centres, or of a centre and a corner.
template <class T, class M, class From = from_now>
[[nodiscard]] constexpr T round_approach_time(const M& m, int unit, rounding mode, const From& counted = {}) {
    const auto q = quadratic_of(m);
    const radicand<root_sum_integer_for<M>> d(discriminant_halved{}(q));
    return counted.is_now() ? round_root_from_now<T>(q, d, unit, mode)
                            : round_root<T>(q.a, q.h, d, unit, mode, counted);
}

// The time of an event of a wall.
template <class T, int N, class M, class From = from_now>
[[nodiscard]] constexpr T round_wall_time(event_kind kind, int index, const M& m, int unit, rounding mode,
                                          const From& counted = {}) {
    using Z = root_sum_integer_for<M>;
    if (kind == event_kind::face) {
        const auto face = face_of(m);
        return round_plane_time<T>(face, radicand<Z>(graze::squared_norm(face.n)), unit, mode, counted);
    }
    if constexpr (N == 3) {
        if (kind == event_kind::edge) {
            const auto view = seen_from(m, edge_view(index));
            return round_root<T>(edge_a{}(view), edge_h{}(view), radicand<Z>(edge_discriminant{}(view)), unit, mode,
                                 counted);
        }
    }
    return round_approach_time<T>(corner_motion(seen_from(m, wall_view{index, false})), unit, mode, counted);
}

// The time of a pair of kind P.
template <class T, int N, class P, class M, class From = from_now>
[[nodiscard]] constexpr T round_pair_time(event_kind kind, int index, const M& m, int unit, rounding mode,
                                          const From& counted = {}) {
    using Z = root_sum_integer_for<M>;
    if constexpr (std::is_same_v<P, ball_and_wall<N>>) {
        return round_wall_time<T, N>(kind, index, m, unit, mode, counted);
    } else if constexpr (std::is_same_v<P, ball_and_plane<N>>) {
        return round_plane_time<T>(m, radicand<Z>(graze::squared_norm(m.n)), unit, mode, counted);
    } else {
        return round_approach_time<T>(m, unit, mode, counted);
    }
}

// The time of an event after its start, from its inputs.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] constexpr T round_exactly(const event<N, U>& e, rounding mode) {
    return with_exact_event(e, [&]<class P>(P, const auto& m, const auto& counted, int unit) {
        return round_pair_time<T, N, P>(e.kind, e.index, m, unit, mode, counted);
    });
}

// A mover of an event of two movers.
template <moving B, int N, class U>
[[nodiscard]] constexpr B mover_in(const event<N, U>& e, std::size_t which) noexcept {
    if constexpr (is_flight<B>) {
        return {mover_in<ball<N, U>>(e, which), e.timed ? e.since(two_balls<N>{})[which] : U(0)};
    } else {
        B b;
        for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
            b.position[static_cast<int>(i)] = e.row[which * N + i];
            b.velocity[static_cast<int>(i)] = e.row[two_balls<N>::lengths + which * N + i];
        }
        b.radius = e.row[2 * N + which];
        return b;
    }
}

// The time of two movers by doubles and double words, and by integers if these leave it open.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] T round_further(const event<N, U>& e, rounding mode) {
    if constexpr (std::is_floating_point_v<U>) {
        const further_time t = find_further_time(mover_in<flight<N, U>>(e, 0), mover_in<flight<N, U>>(e, 1),
                                                 e.timed ? tried::time : tried::step);
        if (const auto rounded = round_further_time<T>(t, mode)) {
            return *rounded;
        }
    }
    return round_exactly<T>(e, mode);
}

// The time of two balls that do not overlap, near `time`, rounded to nearest: by doubles if that leaves no doubt.
//
// Only the rounding direction of the environment matters if the inputs become doubles as they are. Where subnormals are
// read or written as zeros, an operation loses at most 2^-1022, and R and t0 times that (below 2^201 each) go into |y|²
// - R²: less than 2^-700, while the error that is allowed for is at least 2^-99 (|Δx|² + R²) > 2^-299. A result that
// these bounds leave in no doubt is no subnormal double; a subnormal float is compared with zero, and is in doubt where
// it is read as zero. An input that is a subnormal float, up to 2^-126, must not be read as zero.
template <class T, int N, class U, class Step = time_of_row<N, U>>
struct nearest_time {
    const event<N, U>* e;
    double time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] T operator()(std::bool_constant<Fused> fused) const {
        const auto found = Step{e->row.data(), time}(fused);
        const ends<double> interval = ends_of<T>(found.time);
        const bool to_nearest = std::is_same_v<U, float> ? rounds_to_nearest() : adds_to_nearest();
        if (all_hold(found.good, agree<T>(interval), to_nearest)) [[likely]] {
            return static_cast<T>(interval.upper);
        }
        return round_further<T>(*e, rounding::nearest);
    }
};

// The same where `time` may be far off.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] T round_hard_time(const event<N, U>& e, double time) {
    const T nearest = with_fused_products(nearest_time<T, N, U, hard_time_of_row<N, U>>{&e, time}, T(-1));
    return nearest < 0 ? round_further<T>(e, rounding::nearest) : nearest; // balls don't touch before 0
}

// The same for a double.
template <class T>
[[nodiscard]] constexpr T round_double(const double& x, rounding mode) {
    const binary b = to_binary(x);
    if (b.significand == 0) {
        return T(0);
    }
    const leading exact =
        leading_of_words(0, static_cast<std::uint64_t>(b.significand < 0 ? -b.significand : b.significand), b.exponent,
                         b.significand < 0, 0);
    return round_estimate<T>(exact, mode, [](std::uint64_t, int) { return 0; });
}

// The time of an event in the enclosure: if both ends round to the same number, so does the time.
template <class T, int N, class U>
[[nodiscard, gnu::always_inline]] constexpr inline T round_time(const event<N, U>& e, const enclosure& bounds,
                                                                rounding mode) {
    if (e.overlap) {
        return static_cast<T>(e.start());
    }
    if (e.nearest && mode == rounding::nearest) {
        if constexpr (std::is_same_v<T, double>) {
            return bounds.near;
        } else {
            return round_double<T>(bounds.near, mode);
        }
    }
    if constexpr (std::numeric_limits<T>::digits < 40) { // for doubles the enclosure is hardly ever narrow enough
        const double upper = bounds.upper();
        const T low = round_double<T>(bounds.lower(), mode);
        if (bits_of(low) == bits_of(round_double<T>(upper, mode))) {
            return low;
        }
    }
    if (!std::is_constant_evaluated()) {
        if constexpr (is_rounded_by_doubles<U>) { // enough for nearly every time
            if (mode == rounding::nearest && e.kind == event_kind::balls && !e.timed) [[likely]] {
                if (bounds.error > 0x1p-36 * bounds.near) [[unlikely]] {
                    return round_hard_time<T>(e, bounds.near);
                }
                return with_best_products(nearest_time<T, N, U>{&e, bounds.near});
            }
        }
        if (const auto fast = round_in_doubles<T>(e, bounds.near, mode)) {
            return *fast;
        }
        if (e.kind == event_kind::balls) {
            return round_further<T>(e, mode);
        }
    }
    return round_exactly<T>(e, mode);
}

} // namespace graze::inline v0_1::detail
