// What becomes of a flight and a plane or a wall, exactly.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

#include <concepts>

namespace graze::inline v0_1 {

// Whether a flight meets a plane or a wall from its `since` on, exactly. Throws as for balls, naming the flight.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const flight<N, T>& f, const plane<N, T>& p, Observer&& observer = {}) {
    detail::check(f, "flight");
    return classify(f.state, p, observer);
}
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const flight<N, T>& f, const wall<N, T>& w, Observer&& observer = {}) {
    detail::check(f, "flight");
    return classify(f.state, w, observer);
}

} // namespace graze::inline v0_1
