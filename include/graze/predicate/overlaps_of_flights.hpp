// Whether a flight and a plane, wall or triangle are inside each other at its epoch, whatever it does next.
#pragma once

#include <graze/predicate/classify_flights.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>

namespace graze::inline v0_1 {

// Whether a flight and a plane, a wall or a triangle are inside each other at its `since`, exactly. Throws as classify
// does.
template <int N, std::floating_point T, detail::standing_in<N, T> Shape, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const flight<N, T>& f, const Shape& shape, Observer&& observer = {}) {
    detail::check(f, "flight");
    return overlaps(f.state, shape, observer);
}

} // namespace graze::inline v0_1
