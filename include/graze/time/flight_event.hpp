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
        return with_exact_flights<N>(in, [&](const auto& pair) { return f(pair.motion(), pair.start()); });
    } else {
        const auto in_type = [&]<class I>() { return f(P::template motion<I>(in.pair), in.since.template get<I>(0)); };
        if (std::max(in.pair.width(), in.since.width) <= two_limb_width) {
            return in_type.template operator()<integer<two_limb_width>>();
        }
        return in_type.template operator()<sparse_integer<wide_flights::length>>();
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

// Whether the integers of an event in units of 2^unit, which are not above its own, are the dense ones.
template <int N, class T>
[[nodiscard]] constexpr bool is_narrow(const flight_event<N, T>& e, int unit) {
    return with_timed_inputs(e, [unit]<class In, class P>(In in, P) {
        in.settle(unit);
        if constexpr (std::is_same_v<P, two_balls<N>>) {
            return is_narrow(in);
        } else {
            return std::max(in.pair.width(), in.since.width) <= two_limb_width;
        }
    });
}

// What holds the coefficients of all kinds, in the dense integers and in the others: the widest are a face's, u·n for
// two edges squared, times a time twice.
template <bool Narrow>
using timed_coefficient =
    std::conditional_t<Narrow, integer<8 * two_limb_width + 64>, sparse_integer<8 * wide_flights::length + 64>>;
template <bool Narrow>
using timed_quadratic = quadratic<timed_coefficient<Narrow>, timed_coefficient<Narrow>, timed_coefficient<Narrow>>;

template <bool Narrow, int N, class T>
[[nodiscard]] constexpr timed_quadratic<Narrow> timed_quadratic_of(const flight_event<N, T>& e, int unit) {
    return with_timed_inputs(e, [&]<class In, class P>(In in, P) {
        in.settle(unit);
        const auto take = [](const auto& q) { return timed_quadratic<Narrow>{q.a, q.h, q.c}; };
        if constexpr (std::is_same_v<P, two_balls<N>>) {
            const auto pair = flights_in<std::conditional_t<Narrow, narrow_flights, wide_flights>>(in);
            return with_timed_quadratic<N, P>(e, pair.motion(), pair.start(), take);
        } else {
            using I = std::conditional_t<Narrow, integer<two_limb_width>, sparse_integer<wide_flights::length>>;
            return with_timed_quadratic<N, P>(e, P::template motion<I>(in.pair), in.since.template get<I>(0), take);
        }
    });
}

// The sign of the first time less the second, of two pairs of flights, where dense integers hold both; 2 where not.
template <int N, class T>
[[nodiscard]] constexpr int compare_narrow(const flight_event<N, T>& x, const flight_event<N, T>& y) {
    using P = two_balls<N>;
    auto inputs_x = lift_timed<P>(x.pair.row, x.since);
    auto inputs_y = lift_timed<P>(y.pair.row, y.since);
    const int unit = std::min(inputs_x.unit(), inputs_y.unit());
    inputs_x.settle(unit);
    inputs_y.settle(unit);
    if (!is_narrow(inputs_x) || !is_narrow(inputs_y)) {
        return 2;
    }
    const auto a = flights_in<narrow_flights>(inputs_x);
    const auto b = flights_in<narrow_flights>(inputs_y);
    return with_timed_quadratic<N, P>(x, a.motion(), a.start(), [&](const auto& q) {
        return with_timed_quadratic<N, P>(y, b.motion(), b.start(), [&](const auto& s) { return root_order{}(q, s); });
    });
}

// The sign of the first time less the second.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const flight_event<N, T>& x, const flight_event<N, T>& y) {
    if (x.pair.kind == event_kind::balls && y.pair.kind == event_kind::balls) {
        if (const int order = compare_narrow(x, y); order != 2) {
            return order;
        }
    }
    const int unit = std::min(unit_of(x), unit_of(y));
    if (is_narrow(x, unit) && is_narrow(y, unit)) {
        return root_order{}(timed_quadratic_of<true>(x, unit), timed_quadratic_of<true>(y, unit));
    }
    return root_order{}(timed_quadratic_of<false>(x, unit), timed_quadratic_of<false>(y, unit));
}

// The sign of the time less m, m finite.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const flight_event<N, T>& x, const binary& m) {
    const int own = unit_of(x);
    const int unit = m.significand != 0 ? std::min(own, m.exponent) : own;
    using number = sparse_integer<wide_flights::time + 64>;
    const auto numerator = number::from_shifted(m.significand, m.significand != 0 ? m.exponent - unit : 0);
    const auto q = timed_quadratic_of<false>(x, unit);
    const number one(1);
    return root_against(sign(value_at{}(q, numerator, one)), sign(slope_at{}(q, numerator, one)));
}

// The time of an event, from its inputs.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] constexpr T round_exactly(const flight_event<N, U>& e, rounding mode) {
    return with_timed_inputs(e, [&]<class In, class P>(In in, P) {
        const int unit = in.unit();
        in.settle(unit);
        return with_timed_motion<N, P>(in, [&]<class M, class S>(const M& m, const S& start) {
            return round_pair_time<T, N, P>(e.pair.kind, e.pair.index, m, unit, mode, from_earlier<S>{start});
        });
    });
}

} // namespace graze::inline v0_1::detail
