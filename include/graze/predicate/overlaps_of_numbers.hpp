// overlaps for exact number types: the formulas as they are.
#pragma once

#include <graze/predicate/classify_numbers.hpp>

namespace graze::inline v0_1 {

// Whether two things are inside each other now, exactly; touching is not overlapping. A wall's edges are not parallel.
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr bool overlaps(const ball<N, T>& a, const ball<N, T>& b) {
    return graze::sign(coefficient_c{}(relative_motion_of(a, b))) < 0;
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr bool overlaps(const ball<N, T>& b, const plane<N, T>& p) {
    return graze::sign(plane_clearance{}(relative_motion_of(b, p))) < 0;
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr bool overlaps(const ball<N, T>& b, const wall<N, T>& w) {
    return detail::with_decision(b, w, [](const auto&, const auto& decision) { return decision.clearance() < 0; });
}
template <exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr bool overlaps(const ball<3, T>& b, const triangle<T>& t) {
    return detail::with_decision(b, t, [](const auto&, const auto& decision) { return decision.clearance() < 0; });
}

} // namespace graze::inline v0_1
