// A collision as the smaller root of an exact quadratic, counted from t = 0.
#pragma once

#include <graze/formula/root_order.hpp>
#include <graze/pair/flight_pair.hpp>
#include <graze/time/event.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// use(inputs, P) with an event's inputs before lifting. A ball is a flight since 0.
template <int N, class T, class F>
[[nodiscard]] constexpr auto with_timed_inputs(const event<N, T>& e, F use) {
    return with_pair<N>(e.kind, [&]<class P>(P pair) { return use(lift_timed<P>(e.row, e.since(pair)), pair); });
}
template <int N, class T>
[[nodiscard]] constexpr int unit_of(const event<N, T>& e) {
    return with_timed_inputs(e, [](const auto& in, auto) { return in.unit(); });
}

// f(motion, start) with the exact motion of lifted inputs at their start.
template <int N, class P, class F>
[[nodiscard]] constexpr auto with_timed_motion(const timed_inputs<P>& in, F f) {
    if constexpr (std::is_same_v<P, two_balls<N>>) {
        const auto pair = flights_in<N>(in);
        return f(pair.motion(), pair.start());
    } else {
        return f(P::template motion<big_integer>(in.pair), in.since.template get<big_integer>(0));
    }
}

// Times count from the instant of the positions, so a way (speed times time) stays as it is.
struct from_now {
    template <class W, class S>
    [[nodiscard]] constexpr const W& operator()(const W& way, const S&) const noexcept {
        return way;
    }
    [[nodiscard]] constexpr bool is_now() const noexcept { return true; }
};
// Times count from an instant that is earlier by `start`.
template <class I>
struct from_earlier {
    I start;
    template <class W, class S>
    [[nodiscard]] constexpr auto operator()(const W& way, const S& speed) const {
        return way + start * speed;
    }
    [[nodiscard]] constexpr bool is_now() const noexcept { return graze::sign(start) == 0; }
};

// f(P, motion, from, unit) with an event's exact motion at its start, the instant from which its times count, and the
// exponent of their unit: in integers of one limb if balls' inputs fit, otherwise of any size.
template <int N, class T, class F>
[[nodiscard]] constexpr auto with_exact_event(const event<N, T>& e, F f) {
    return with_timed_inputs(e, [&]<class In, class P>(In in, P pair) {
        const int unit = in.unit();
        if constexpr (narrow_pays<P>) {
            if (!e.timed && in.pair.width() <= one_limb_width) {
                return f(pair, P::template motion<integer<one_limb_width>>(in.pair), from_now{}, unit);
            }
        }
        in.settle(unit);
        timed_workspace room;
        in.use(room);
        return with_timed_motion<N, P>(
            in, [&]<class M, class S>(const M& m, const S& start) { return f(pair, m, from_earlier<S>{start}, unit); });
    });
}

using big_quadratic = quadratic<big_integer, big_integer, big_integer>;

// The quadratic of an event, counted from t = 0 in units of 2^unit. If the event is at its start, that is a root.
template <int N, class T>
[[nodiscard]] constexpr big_quadratic quadratic_in(const event<N, T>& e, int unit, workspace& room) {
    return with_timed_inputs(e, [&]<class In, class P>(In in, P) {
        in.settle(unit);
        in.use(room);
        return with_timed_motion<N, P>(in, [&](const auto& m, const auto& start) {
            return with_quadratic<N, P>(e.kind, e.index, m, [&](const auto& q) {
                const auto shifted = counted_from(quadratic{q.a, q.h, e.overlap ? big_integer() : q.c}, start);
                return big_quadratic{shifted.a, shifted.h, shifted.c};
            });
        });
    });
}

// The same sign for two pairs of balls whose inputs fit in one limb; false if they do not.
template <int N, class T>
[[nodiscard]] constexpr bool compare_narrow(const event<N, T>& x, const event<N, T>& y, int& sign) {
    if (x.kind != event_kind::balls || y.kind != event_kind::balls || x.timed || y.timed) {
        return false;
    }
    using P = two_balls<N>;
    using I = integer<one_limb_width>;
    auto in_x = lift_row<P>(x.row);
    auto in_y = lift_row<P>(y.row);
    align(in_x.length, in_y.length);
    align(in_x.velocity, in_y.velocity);
    if (std::max(in_x.width(), in_y.width()) > one_limb_width) {
        return false;
    }
    const auto q = quadratic_of(P::template motion<I>(in_x));
    const auto s = quadratic_of(P::template motion<I>(in_y));
    using C = std::remove_cvref_t<decltype(q.c)>;
    sign = root_order{}(quadratic{q.a, q.h, x.overlap ? C(0) : q.c}, quadratic{s.a, s.h, y.overlap ? C(0) : s.c});
    return true;
}

// The sign of τ(x) - τ(y).
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const event<N, T>& x, const event<N, T>& y) {
    if (int sign = 0; compare_narrow(x, y, sign)) {
        return sign;
    }
    const int unit = std::min(unit_of(x), unit_of(y));
    timed_workspace room;
    return root_order{}(quadratic_in(x, unit, room), quadratic_in(y, unit, room));
}

// The sign of τ(x) - m for a finite m. In the event's unit of time, m = M 2^j.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const event<N, T>& x, const binary& m) {
    const int unit = unit_of(x);
    const int power = m.exponent - unit;
    timed_workspace room;
    const auto numerator = big_integer::from_shifted(room, m.significand, power > 0 ? power : 0);
    const auto denominator = big_integer::from_shifted(room, 1, power < 0 ? -power : 0);
    const big_quadratic q = quadratic_in(x, unit, room);
    return root_against(sign(value_at{}(q, numerator, denominator)), sign(slope_at{}(q, numerator, denominator)));
}

} // namespace graze::inline v0_1::detail
