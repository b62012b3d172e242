// What becomes of a ball and a plane or a wall, exactly.
#pragma once

#include <graze/formula/encounter.hpp>
#include <graze/pair/plane_signs.hpp>
#include <graze/pair/wall_signs.hpp>
#include <graze/predicate/decide_flat.hpp>

namespace graze::inline v0_1 {

// Laws 1 to 4 and 6 of classify_balls.hpp, and
//   7. a plane is never missed and never grazed: what approaches it meets it.

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

namespace detail {

template <int N, class T, class Observer>
[[nodiscard]] constexpr wall_encounter decide_wall(const ball<N, T>& b, const wall<N, T>& w, Observer&& observer) {
    stage by{};
    const flat_answer found = decide_flat<flat_question::feature>(b, w, by);
    observer(by);
    return {found.what, found.where, found.index};
}

} // namespace detail

// Laws 1 to 4 and 6 of classify_balls.hpp, and
//   8. a wall is met no earlier than its plane, where both are met.

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

} // namespace graze::inline v0_1
