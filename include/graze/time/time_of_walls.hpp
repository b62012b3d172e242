// When a ball meets a plane, a wall or a triangle first, if it does.
#pragma once

#include <graze/predicate/classify_walls.hpp>
#include <graze/time/enclose_flat.hpp>
#include <graze/time/time_of_shapes.hpp>

#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// The time of an event about which nothing else is known: by double words, or by its exact quadratic.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr impact_time<N, T> enclosed_slowly(const event<N, T>& e, encounter what) {
    if constexpr (is_rounded_by_doubles<T>) {
        if (!std::is_constant_evaluated() && what == encounter::hit && rounds_to_nearest()) {
            const bounded<double> t = as_bounds(hit_time(e));
            const double error = absolute(t.low) + t.error + 0x1p-49 * absolute(t.high);
            if (t.high > 0x1p-300 && error < 0x1p-20 * t.high) {
                return impact_time<N, T>(impact_time_key{}, enclosure{t.high, error}, e);
            }
        }
    }
    return enclosed_exactly(e);
}

template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr std::optional<impact_time<N, T>>
time_of_plane_slowly(const ball<N, T>& b, const plane<N, T>& p, encounter what) {
    return enclosed_slowly(event<N, T>(ball_and_plane<N>{}, b, p, event_kind::plane, 0, what == encounter::overlap),
                           what);
}

// found: with the feature's number in the wall.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr std::optional<impact_time<N, T>>
time_of_flat_slowly(const ball<N, T>& b, const wall<N, T>& w, const flat_answer& found) {
    const event<N, T> e(ball_and_wall<N>{}, b, w, kind_of<N>(found.where), found.index,
                        found.what == encounter::overlap);
    return enclosed_slowly(e, found.what);
}

template <int N, class T, class Shape, class Observer>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_flat(const ball<N, T>& b, const Shape& shape,
                                                                      Observer&& observer) {
    stage by{};
    const auto [found, bounds] = meet_flat(b, shape, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    if (bounds.is_known()) [[likely]] {
        return std::optional<impact_time<N, T>>(std::in_place, impact_time_key{}, bounds, ball_and_wall<N>{}, b, shape,
                                                kind_of<N>(found.where), number_in_wall<Shape>(found), false);
    }
    return time_of_flat_slowly<N, T>(b, as_wall(shape), {true, found.what, found.where, number_in_wall<Shape>(found)});
}

} // namespace detail

// The exact time at which a ball touches a plane first; empty when it recedes. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const ball<N, T>& b, const plane<N, T>& p,
                                                                        Observer&& observer = {}) {
    stage by{};
    const auto [found, bounds] = detail::meet_flat(b, p, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    if (bounds.is_known()) [[likely]] {
        return std::optional<impact_time<N, T>>(std::in_place, detail::impact_time_key{}, bounds,
                                                detail::ball_and_plane<N>{}, b, p, detail::event_kind::plane, 0, false);
    }
    return detail::time_of_plane_slowly(b, p, found.what);
}

// The exact time at which a ball touches a wall's or a triangle's face, edge or corner first; empty for recede and
// miss. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const ball<N, T>& b, const wall<N, T>& w,
                                                                        Observer&& observer = {}) {
    return detail::time_of_flat(b, w, observer);
}
template <class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<3, T>> time_of_impact(const ball<3, T>& b, const triangle<T>& t,
                                                                        Observer&& observer = {}) {
    return detail::time_of_flat(b, t, observer);
}

} // namespace graze::inline v0_1
