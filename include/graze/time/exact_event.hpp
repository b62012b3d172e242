// A collision as the smaller root of an exact quadratic.
#pragma once

#include <graze/exact/integer.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/root_order.hpp>
#include <graze/pair/flight_pair.hpp>
#include <graze/time/event.hpp>

namespace graze::inline v0_1::detail {

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

using big_quadratic = quadratic<big_integer, big_integer, big_integer>;

// The smaller root of a quadratic, counted from `start`, in units of 2^unit.
struct exact_root {
    big_quadratic from_start;
    big_integer start;
    int unit;
};

// For a pair without epochs: the exponent of its unit of time.
template <class In>
[[nodiscard]] constexpr int unit_of(const In& in) noexcept {
    return in.length.exponent - in.velocity.exponent;
}

// That of an event of pair kind P.
template <class P, bool Timed, int N, class T>
[[nodiscard]] constexpr exact_root exact_root_of(const event_row<N, T>& e, workspace& room) {
    const auto root = [&](const auto& m, const big_integer& start, int unit) {
        return exact_root{quadratic_of_pair<N, P>(e.kind, e.index, m), start, unit};
    };
    if constexpr (Timed) {
        auto in = lift_timed<P>(e.row, e.since(P{}));
        const int unit = in.unit();
        in.settle(unit);
        in.use(room);
        if constexpr (std::is_same_v<P, two_balls<N>>) {
            const auto pair = flights_in<N>(in);
            return root(pair.motion(), pair.start(), unit);
        } else {
            return root(P::template motion<big_integer>(in.pair), in.since.template get<big_integer>(0), unit);
        }
    } else {
        auto in = lift_row<P>(e.row);
        in.use(room);
        const int unit = unit_of(in);
        return root(P::template motion<big_integer>(in), 0, unit);
    }
}

// The quadratic whose root counts from t = 0, in units of 2^unit, which must not be above the root's own. at_start:
// whether the root is to be the start itself.
[[nodiscard, gnu::noinline]] constexpr big_quadratic counted_from_zero(const exact_root& r, bool at_start, int unit,
                                                                       workspace& room) {
    big_quadratic q{r.from_start.a, r.from_start.h, at_start ? big_integer() : r.from_start.c};
    big_integer start = r.start;
    if (r.unit != unit) {
        const auto units = big_integer::from_shifted(room, 1, r.unit - unit);
        q.h = q.h * units;
        q.c = q.c * units * units;
        start = start * units;
    }
    return start.sign() == 0 ? q : counted_from(q, start);
}

// The quadratic of two balls from their start, in integers of one limb. A sum of three squares of differences then has
// two limbs.
using short_integer = integer<61>;
template <class P, class In>
[[nodiscard]] constexpr auto short_quadratic(const In& in) {
    return quadratic_of(P::template motion<short_integer>(in));
}

// The sign of τ(x) - τ(y) for two pairs of balls whose inputs fit in one limb; false if they do not. Equal times are
// common there: balls on a grid.
template <int N, class T>
[[nodiscard]] constexpr bool compare_short(const event_row<N, T>& x, const event_row<N, T>& y, int& sign) {
    if (!x.is_of_balls() || !y.is_of_balls()) {
        return false;
    }
    using P = two_balls<N>;
    auto in_x = lift_row<P>(x.row);
    auto in_y = lift_row<P>(y.row);
    align(in_x.length, in_y.length);
    align(in_x.velocity, in_y.velocity);
    if (in_x.width() > short_integer::bits || in_y.width() > short_integer::bits) {
        return false;
    }
    const auto q = short_quadratic<P>(in_x);
    const auto s = short_quadratic<P>(in_y);
    using C = std::remove_cvref_t<decltype(q.c)>;
    sign = root_order{}(quadratic{q.a, q.h, x.overlap ? C(0) : q.c}, quadratic{s.a, s.h, y.overlap ? C(0) : s.c});
    return true;
}

// The sign of τ(x) - τ(y).
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const event<N, T>& x, const event<N, T>& y) {
    if (int sign = 0; compare_short(x, y, sign)) {
        return sign;
    }
    timed_workspace room;
    const exact_root r = x.procedures->root(x, room);
    const exact_root s = y.procedures->root(y, room);
    const int unit = r.unit < s.unit ? r.unit : s.unit;
    return root_order{}(counted_from_zero(r, x.overlap, unit, room), counted_from_zero(s, y.overlap, unit, room));
}

// The sign of τ(x) - m for a finite m. In the event's unit of time, m = M 2^j.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr int compare_exactly(const event<N, T>& x, const binary& m) {
    timed_workspace room;
    const exact_root r = x.procedures->root(x, room);
    const int power = m.exponent - r.unit;
    const auto numerator = big_integer::from_shifted(room, m.significand, power > 0 ? power : 0);
    const auto denominator = big_integer::from_shifted(room, 1, power < 0 ? -power : 0);
    const big_quadratic q = counted_from_zero(r, x.overlap, r.unit, room);
    return root_against(sign(value_at{}(q, numerator, denominator)), sign(slope_at{}(q, numerator, denominator)));
}

} // namespace graze::inline v0_1::detail
