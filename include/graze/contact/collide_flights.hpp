// When, where and how a flight meets a plane or a wall and leaves it, every number correctly rounded.
#pragma once

#include <graze/contact/collide_walls.hpp>
#include <graze/time/time_of_flights.hpp>

namespace graze::inline v0_1 {

namespace detail {

// The clock of a flight's `since`.
template <class T>
struct clock_of_flight {
    const T& since;

    [[nodiscard]] bounded_word operator()(const bounded_word& time) const noexcept {
        return time + bounded_word(static_cast<double>(since));
    }
    [[nodiscard]] bounded<double> operator()(const bounded<double>& time) const noexcept {
        const auto sum = two_sum(static_cast<double>(since), time.high);
        return {sum.value, sum.error + time.low, 1.01 * time.error + 0x1p-104 * absolute(sum.value)};
    }
    // Rounds the time, if it is wanted, and returns what is left.
    template <class P, int N, class Shape>
    [[nodiscard]] constexpr parts without_time(wall_contact<N, T>& c, parts wanted, const wall_encounter& found, P pair,
                                               const ball<N, T>& b, const Shape& shape) const {
        if (has_time(wanted)) {
            const auto kind = std::is_same_v<P, ball_and_plane<N>> ? event_kind::plane : kind_of<N>(found.where);
            const event<N, T> e(pair, flight<N, T>{b, since}, shape, kind, found.index, false);
            c.time =
                found.what == encounter::overlap ? start_of<T>({since, since}) : round_exactly<T>(e, rounding::nearest);
        }
        return wanted & ~parts{1};
    }
};

} // namespace detail

// The contact of a flight and an infinite plane; empty when it recedes. The mass has no part in it.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const flight<N, T>& f, const plane<N, T>& p,
                                                                  Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto met = detail::meet_flat(f.state, p, by);
    return detail::contact_of(detail::ball_and_plane<N>{}, {met.found.what, feature::face, 0}, by, f.state, p, observer,
                              detail::clock_of_flight<T>{f.since}, met.bounds.near);
}

// The contact of a flight and a wall, at its face, an edge or a corner, whichever is met first.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const flight<N, T>& f, const wall<N, T>& w,
                                                                  Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto met = detail::meet_flat(f.state, w, by);
    return detail::contact_of(detail::ball_and_wall<N>{}, {met.found.what, met.found.where, met.found.index}, by,
                              f.state, w, observer, detail::clock_of_flight<T>{f.since}, met.bounds.near);
}

} // namespace graze::inline v0_1
