// When a flight and a plane or a wall meet first, if they do.
#pragma once

#include <graze/predicate/classify_flights.hpp>
#include <graze/time/time_of_walls.hpp>

#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// The time of an event of a flight and a plane or a wall that happens within the bounds, if these are known, after the
// flight's since.
template <int N, class T>
[[nodiscard]] constexpr impact_time<N, T> with_clock(const event<N, T>& e, const enclosure& bounds) {
    if (bounds.is_known()) [[likely]] {
        return impact_time<N, T>(impact_time_key{}, counted_from<T>(static_cast<double>(e.start()), bounds), e);
    }
    return enclosed_exactly(e);
}

} // namespace detail

// The exact time at which a flight touches a plane first; empty when it recedes.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const flight<N, T>& f, const plane<N, T>& p,
                                                                        Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto [found, bounds] = detail::meet_flat(f.state, p, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    return detail::with_clock(detail::event<N, T>(detail::ball_and_plane<N>{}, f, p, detail::event_kind::plane, 0,
                                                  found.what == encounter::overlap),
                              bounds);
}

// The exact time at which a flight touches a wall's face, edge or corner first; empty for recede and miss.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const flight<N, T>& f, const wall<N, T>& w,
                                                                        Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto [found, bounds] = detail::meet_flat(f.state, w, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    return detail::with_clock(detail::event<N, T>(detail::ball_and_wall<N>{}, f, w, detail::kind_of<N>(found),
                                                  found.index, found.what == encounter::overlap),
                              bounds);
}

} // namespace graze::inline v0_1
