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
    const auto m = relative_motion_of(b, w);
    const detail::exact_signs<std::remove_cvref_t<decltype(m)>> signs(m);
    return wall_decision<N, decltype(signs)>(signs).overlaps();
}

} // namespace graze::inline v0_1
