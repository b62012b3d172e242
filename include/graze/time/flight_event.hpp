// A collision of flights: the smaller root of an exact quadratic, counted from t = 0.
#pragma once

#include <graze/pair/flight_pair.hpp>
#include <graze/time/event.hpp>
#include <graze/time/rounded_time.hpp>

namespace graze::inline v0_1::detail {

// Whether s < t, exactly, of any finite numbers, by their bits.
template <class T>
[[nodiscard]] constexpr bool is_earlier(const T& s, const T& t) noexcept {
    const auto order = [](const T& x) {
        const auto magnitude = static_cast<std::int64_t>(order_of_magnitude(x));
        return split(x).significand < 0 ? -magnitude : magnitude;
    };
    return order(s) < order(t);
}

// The later of two instants; a zero as +0.
template <class T>
[[nodiscard]] constexpr T start_of(const std::array<T, 2>& since) noexcept {
    const T& later = is_earlier(since[0], since[1]) ? since[1] : since[0];
    return from_bits<T>(is_zero(later) ? 0 : bits_of(later), false);
}

// What met, and since when each of the two was on its way; a plane's and a wall's is the flight's. An event that is at
// its start (pair.overlap) overlaps or touches then.
template <int N, class T>
struct flight_event {
    event<N, T> pair;
    std::array<T, 2> since;

    template <class P, class Y>
    constexpr flight_event(P, const ball<N, T>& x, const Y& y, event_kind kind, int index, bool at_start,
                           const T& since_x, const T& since_y) noexcept
        : pair(P{}, x, y, kind, index, at_start), since{since_x, since_y} {}

    [[nodiscard]] constexpr T start() const noexcept { return start_of(since); }
};

// f(motion, start) with the exact motion of settled inputs at their start.
template <int N, class P, class F>
[[nodiscard]] constexpr auto with_timed_motion(const timed_inputs<P>& in, F f) {
    if constexpr (std::is_same_v<P, two_balls<N>>) {
        const auto pair = flights_in<N>(in);
        return f(pair.motion(), pair.start());
    } else {
        return f(P::template motion<big_integer>(in.pair), in.since.template get<big_integer>(0));
    }
}

// use(inputs, P) with an event's inputs, not yet settled.
template <int N, class T, class F>
[[nodiscard]] constexpr auto with_timed_inputs(const flight_event<N, T>& e, F use) {
    return with_pair<N>(e.pair.kind, [&]<class P>(P pair) { return use(lift_timed<P>(e.pair.row, e.since), pair); });
}
template <int N, class T>
[[nodiscard]] constexpr int unit_of(const flight_event<N, T>& e) {
    return with_timed_inputs(e, [](const auto& in, auto) { return in.unit(); });
}

// The quadratic of a motion at its start, of which 0 is a root if the event is then, counted from t = 0.
template <int N, class P, class T, class M, class S, class F>
[[nodiscard]] constexpr auto with_timed_quadratic(const flight_event<N, T>& e, const M& m, const S& start, F use) {
    return with_quadratic<N, P>(e.pair.kind, e.pair.index, m, [&](auto q) {
        if (e.pair.overlap) {
            q.c = decltype(q.c)(0);
        }
        return use(counted_from(q, start));
    });
}

template <int N, class T>
[[nodiscard]] constexpr big_quadratic timed_quadratic_of(const flight_event<N, T>& e, int unit, workspace& room) {
    return with_timed_inputs(e, [&]<class In, class P>(In in, P) {
        in.settle(unit);
        in.use(room);
        return with_timed_motion<N, P>(in, [&](const auto& m, const auto& start) {
            return with_timed_quadratic<N, P>(e, m, start, [](const auto& q) { return big_quadratic{q.a, q.h, q.c}; });
        });
    });
}

// The sign of the first time less the second.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const flight_event<N, T>& x, const flight_event<N, T>& y) {
    const int unit = std::min(unit_of(x), unit_of(y));
    timed_workspace room;
    return root_order{}(timed_quadratic_of(x, unit, room), timed_quadratic_of(y, unit, room));
}

// The sign of the time less m, m finite.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const flight_event<N, T>& x, const binary& m) {
    const int own = unit_of(x);
    const int unit = m.significand != 0 ? std::min(own, m.exponent) : own;
    timed_workspace room;
    const auto numerator = big_integer::from_shifted(room, m.significand, m.significand != 0 ? m.exponent - unit : 0);
    const big_integer one(1);
    const auto q = timed_quadratic_of(x, unit, room);
    return root_against(sign(value_at{}(q, numerator, one)), sign(slope_at{}(q, numerator, one)));
}

// The time of an event, from its inputs.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] constexpr T round_exactly(const flight_event<N, U>& e, rounding mode) {
    return with_timed_inputs(e, [&]<class In, class P>(In in, P) {
        const int unit = in.unit();
        in.settle(unit);
        timed_workspace room;
        in.use(room);
        return with_timed_motion<N, P>(in, [&]<class M, class S>(const M& m, const S& start) {
            return round_pair_time<T, N, P>(e.pair.kind, e.pair.index, m, unit, mode, from_earlier<S>{start});
        });
    });
}

} // namespace graze::inline v0_1::detail
