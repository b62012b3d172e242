// Whether two flights are inside each other when both have started, whatever they do next.
#pragma once

#include <graze/predicate/classify_flights.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>

namespace graze::inline v0_1 {

// Whether |Δx|² < R² at the later one's `since`, exactly. Touching is not overlapping. Throws as classify does.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const flight<N, T>& a, const flight<N, T>& b, Observer&& observer = {}) {
    if (!std::is_constant_evaluated() && detail::plain_radii(a.state.radius, b.state.radius)) {
        const auto m = detail::rounded_motion(a, b);
        const int s = detail::certain_sign(coefficient_c{}(m.motion), detail::flight_filter<N, T>::c * m.length2);
        if (s != detail::open && m.in_range && m.length2 > detail::smallest_square<T> && m.length2 < 0x1p570 &&
            detail::is_finite(a.state.velocity) && detail::is_finite(b.state.velocity)) {
            observer(stage::filter);
            return s < 0;
        }
    }
    detail::check_flights(a, b);
    const bool inside = detail::with_exact_flights(detail::lift_flights(a, b), [](const auto& pair) {
        return detail::exact_sign(pair.motion(), coefficient_c{}) < 0;
    });
    observer(stage::exact);
    return inside;
}

// Whether a flight and a plane, or a wall, are inside each other at its `since`, exactly. Throws as classify does.
template <int N, std::floating_point T, class Shape, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const flight<N, T>& f, const Shape& shape, Observer&& observer = {}) {
    detail::check(f, "flight");
    return overlaps(f.state, shape, observer);
}

} // namespace graze::inline v0_1
