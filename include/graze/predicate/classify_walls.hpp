// The exact encounter of a ball with a plane, a wall or a triangle.
#pragma once

#include <graze/formula/encounter.hpp>
#include <graze/pair/plane_signs.hpp>
#include <graze/predicate/decide_flat.hpp>

namespace graze::inline v0_1 {

// Laws 1 to 4 and 6 of classify_balls.hpp, and
//   7. a plane is never missed and never grazed: a ball that approaches it meets it.

// Whether a ball meets an infinite plane, exactly, for every finite input: recede, overlap or hit. Throws
// std::domain_error that names the argument and the field when an input is not finite, the radius is negative or the
// normal is zero; in a constant expression such input does not compile. Eq. (33), completed with the radius.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline encounter classify(const ball<N, T>& b, const plane<N, T>& p,
                                                                      Observer&& observer = {}) {
    stage by = stage::filter;
    bool in_doubles = !std::is_constant_evaluated() || detail::is_moderate(b, p);
    const encounter what = in_doubles ? detail::decide_plane(detail::filtered_plane<N, T>(b, p), b, p, by)
                                      : detail::decide_plane_slowly(b, p, detail::flat_question::what, by).what;
    observer(by);
    return what;
}

// Laws 1 to 4 and 6 of classify_balls.hpp, and
//   8. a wall is met no earlier than its plane, where both are met;
//   16. of the two triangles into which a diagonal cuts a wall, the first that is met is met when the wall is, and with
//       the same encounter, if the ball does not touch it at the start and no corner is rounded.

// Whether a ball meets a bounded wall, exactly, for every finite input: its face, an edge or a corner, whichever is
// first. Throws as for a plane when an input is not finite, the radius is negative, an edge is zero or the edges are
// parallel.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const ball<N, T>& b, const wall<N, T>& w, Observer&& observer = {}) {
    stage by{};
    const encounter what = detail::decide_flat<detail::flat_question::what>(b, w, by).what;
    observer(by);
    return what;
}

// The same for a triangle.
template <class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const ball<3, T>& b, const triangle<T>& t, Observer&& observer = {}) {
    stage by{};
    const encounter what = detail::decide_flat<detail::flat_question::what>(b, t, by).what;
    observer(by);
    return what;
}

namespace detail {

template <int N, class T, class Shape, class Observer>
[[nodiscard]] constexpr wall_encounter classify_flat(const ball<N, T>& b, const Shape& shape, Observer&& observer) {
    stage by{};
    const flat_answer found = decide_flat<flat_question::feature>(b, shape, by);
    observer(by);
    return {found.what, found.where, found.index};
}

} // namespace detail

// The encounter as classify returns it, and its feature: the one that the ball touches first, for an overlap the
// closest one now. If features are touched at the same time, the face comes before edges and edges before corners;
// which of several edges it is depends only on the pair. A plane has only its face. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr wall_encounter classify_feature(const ball<N, T>& b, const plane<N, T>& p,
                                                        Observer&& observer = {}) {
    return {classify(b, p, observer), feature::face, 0};
}
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr wall_encounter classify_feature(const ball<N, T>& b, const wall<N, T>& w,
                                                        Observer&& observer = {}) {
    return detail::classify_flat(b, w, observer);
}
template <class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr wall_encounter classify_feature(const ball<3, T>& b, const triangle<T>& t,
                                                        Observer&& observer = {}) {
    return detail::classify_flat(b, t, observer);
}

} // namespace graze::inline v0_1
