// When a flight and a plane, wall or triangle meet first, if they do.
#pragma once

#include <graze/predicate/classify_flights.hpp>
#include <graze/time/time_of_walls.hpp>

#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// The time of an event of a flight and a plane, wall or triangle. It is within the bounds, if these are known, after
// the flight's since.
template <int N, class T>
[[nodiscard]] constexpr impact_time<N, T> with_clock(const event<N, T>& e, const enclosure& bounds) {
    if (bounds.is_known()) [[likely]] {
        return impact_time<N, T>(impact_time_key{}, counted_from<T>(static_cast<double>(e.start()), bounds), e);
    }
    return enclosed_exactly(e);
}

} // namespace detail

// The exact time at which a flight touches a plane, or the face, an edge or a corner of a wall or a triangle, first;
// empty for recede and miss.
template <int N, std::floating_point T, detail::standing_in<N, T> Shape, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const flight<N, T>& f, const Shape& shape,
                                                                        Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto [found, bounds] = detail::meet_flat(f.state, shape, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    using pair = detail::pair_with<Shape>;
    return detail::with_clock(detail::event<N, T>(pair{}, f, shape, detail::kind_of<N>(pair{}, found.where),
                                                  detail::number_in_wall<Shape>(found),
                                                  found.what == encounter::overlap),
                              bounds);
}

} // namespace graze::inline v0_1
