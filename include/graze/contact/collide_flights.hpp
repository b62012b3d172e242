// When, where and how a flight meets a plane, a wall or a triangle and leaves it, every number correctly rounded.
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
    // Rounds the time, if it is wanted, and returns the other components.
    template <class P, int N, class Shape>
    [[nodiscard]] constexpr component_set without_time(wall_contact<N, T>& c, component_set wanted, encounter what,
                                                       int number, P pair, const ball<N, T>& b,
                                                       const Shape& shape) const {
        if (has_time(wanted)) {
            const event_row<N, T> e(pair, flight<N, T>{b, since}, shape, kind_of<N>(pair, c.feature), number, false);
            timed_workspace room;
            c.time = what == encounter::overlap ? start_of<T>({since, since})
                                                : round_exactly<T>(exact_root_of<P, true>(e, room), rounding::nearest);
        }
        return wanted & ~component_set{1};
    }
};

} // namespace detail

// The contact of a flight and a plane, a wall or a triangle, at its face, an edge or a corner, whichever is met first;
// empty for recede and miss. The mass does not matter.
template <int N, std::floating_point T, detail::standing_in<N, T> Shape, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const flight<N, T>& f, const Shape& shape,
                                                                  Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto met = detail::meet_flat(f.state, shape, by);
    return detail::contact_of(detail::pair_with<Shape>{}, {met.found.what, met.found.where, met.found.index}, by,
                              f.state, shape, observer, detail::clock_of_flight<T>{f.since}, met.bounds.near);
}

} // namespace graze::inline v0_1
