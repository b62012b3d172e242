// Whether two things are inside each other now, whatever they do next.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

namespace graze::inline v0_1 {

// Laws 1 to 4 of classify_balls.hpp, and
//   10. classify returns overlap for pairs that overlap and do not recede, and for no others.

namespace detail {

// By the sign of c alone. For balls the answer does not depend on velocities, but bad ones are still rejected.
template <moving B, class Observer>
[[nodiscard]] constexpr bool movers_overlap(const B& a, const B& b, Observer&& observer) {
    using T = number_in<B>;
    const auto& x = state_of(a);
    const auto& y = state_of(b);
    open_number left;
    if (!std::is_constant_evaluated() && plain_radii(x.radius, y.radius) && is_finite(x.velocity) &&
        is_finite(y.velocity)) {
        int s = with_motion_at_start(a, b, [](const auto& m, double length2, bool in_range) {
            const int found = certain_sign(coefficient_c{}(m), filter_of<B>::c * length2);
            return in_range && length2 > smallest_square<T> && length2 < 0x1p570 ? found : open;
        });
        if (s != open) {
            observer(stage::filter);
            return s < 0;
        }
        if constexpr (std::floating_point<T>) {
            s = distance_further(a, b, left);
            if (s != open) {
                observer(stage::double_word);
                return s < 0;
            }
        }
    }
    const auto what = decide_exactly(
        a, b, left, [](const auto& m) { return sign(coefficient_c{}(m)) < 0 ? encounter::overlap : encounter::hit; });
    observer(stage::exact);
    return what == encounter::overlap;
}

} // namespace detail

// Whether |Δx|² < R², exactly. Touching is not overlapping. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const ball<N, T>& a, const ball<N, T>& b, Observer&& observer = {}) {
    return detail::movers_overlap(a, b, observer);
}

// Whether |Δx|² < R² at the later one's `since`, exactly. Touching is not overlapping. Throws as classify does.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const flight<N, T>& a, const flight<N, T>& b, Observer&& observer = {}) {
    return detail::movers_overlap(a, b, observer);
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

// Whether the ball's centre is nearer to the wall or the triangle than its radius, exactly. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const ball<N, T>& b, const wall<N, T>& w, Observer&& observer = {}) {
    stage by{};
    const bool inside = detail::decide_flat<detail::flat_question::clearance>(b, w, by).what == encounter::overlap;
    observer(by);
    return inside;
}
template <class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr bool overlaps(const ball<3, T>& b, const triangle<T>& t, Observer&& observer = {}) {
    stage by{};
    const bool inside = detail::decide_flat<detail::flat_question::clearance>(b, t, by).what == encounter::overlap;
    observer(by);
    return inside;
}

} // namespace graze::inline v0_1
