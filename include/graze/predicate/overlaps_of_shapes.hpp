// Whether two things are inside each other now, whatever they do next.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

namespace graze::inline v0_1 {

// Laws 1 to 4 of classify_balls.hpp, and
//   10. classify says overlap of what overlaps and does not recede, and of nothing else.

// Whether |Δx|² < R², exactly. Touching is not overlapping. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const ball<N, T>& a, const ball<N, T>& b, Observer&& observer = {}) {
    if (!std::is_constant_evaluated() && detail::plain_radii(a.radius, b.radius)) {
        const auto m = detail::rounded_motion(a, b);
        const double length2 = graze::squared_norm(m.dx) + m.R * m.R;
        const int s = detail::certain_sign(coefficient_c{}(m), detail::ball_filter<N, T>::c * length2);
        // Velocities have no part in the answer, but a bad one is still bad.
        if (s != detail::open && length2 > detail::smallest_square<T> && length2 < 0x1p570 &&
            detail::is_finite(a.velocity) && detail::is_finite(b.velocity)) {
            observer(stage::filter);
            return s < 0;
        }
    }
    const bool inside =
        detail::with_exact_balls(a, b, [](const auto& m) { return detail::exact_sign(m, coefficient_c{}) < 0; });
    observer(stage::exact);
    return inside;
}

// Whether the ball's centre is nearer to the plane than its radius, exactly. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const ball<N, T>& b, const plane<N, T>& p, Observer&& observer = {}) {
    stage by = stage::filter;
    if (!std::is_constant_evaluated() || detail::is_moderate(b, p)) {
        if (const auto found = detail::filtered_plane<N, T>(b, p).overlap(b); found.certain) {
            observer(by);
            return found.what == encounter::overlap;
        }
    }
    const auto found = detail::decide_plane_slowly(b, p, detail::flat_question::clearance, by);
    observer(by);
    return found.what == encounter::overlap;
}

// Whether the ball's centre is nearer to the wall than its radius, exactly. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const ball<N, T>& b, const wall<N, T>& w, Observer&& observer = {}) {
    stage by{};
    const bool inside = detail::decide_flat<detail::flat_question::clearance>(b, w, by).what == encounter::overlap;
    observer(by);
    return inside;
}

} // namespace graze::inline v0_1
