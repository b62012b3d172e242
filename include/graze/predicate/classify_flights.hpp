// The exact encounter of a flight with a plane, a wall or a triangle.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

#include <concepts>

namespace graze::inline v0_1 {

// Whether a flight meets a plane, a wall or a triangle from its `since` on, and which feature of it, exactly. Throws as
// for balls, naming the flight.
template <int N, std::floating_point T, detail::standing_in<N, T> Shape, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const flight<N, T>& f, const Shape& shape, Observer&& observer = {}) {
    detail::check(f, "flight");
    return classify(f.state, shape, observer);
}
template <int N, std::floating_point T, detail::standing_in<N, T> Shape, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr wall_encounter classify_feature(const flight<N, T>& f, const Shape& shape,
                                                        Observer&& observer = {}) {
    detail::check(f, "flight");
    return classify_feature(f.state, shape, observer);
}

} // namespace graze::inline v0_1
