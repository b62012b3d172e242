// When the balls of many pairs touch first, asked at once.
#pragma once

#include <graze/pair/batch_blocks.hpp>
#include <graze/time/time_of_shapes.hpp>

#include <limits>
#include <span>

namespace graze::inline v0_1 {

namespace detail {

// What times of T are rounded to.
template <class T>
using rounded_time_of = typename impact_time<2, T>::rounded_type;

// x's time of impact with y, rounded; +infinity if there is none.
template <int N, class T, class Y>
[[nodiscard]] rounded_time_of<T> rounded_impact(const ball<N, T>& x, const Y& y, rounding mode) {
    const auto time = graze::time_of_impact(x, y);
    if (!time) {
        return std::numeric_limits<rounded_time_of<T>>::infinity();
    }
    return mode == rounding::nearest    ? static_cast<rounded_time_of<T>>(*time)
           : mode == rounding::downward ? time->lower()
                                        : time->upper();
}

} // namespace detail

namespace batch {

// When each ball of a touches the ball of the same index of b first, or the one ball, plane or wall b: time[i] is
// time_of_impact(a[i], b[i]) rounded once, to nearest (ties to even) or, as its lower() and upper(), down or up; and
// +infinity where they never touch. The numbers of `time` are of T; for balls of integers they are doubles. What is
// given, thrown and written is as for classify.
template <class A, class B>
requires detail::batch_of<A, B>
void time_of_impact(const A& a, const B& b,
                    std::span<detail::rounded_time_of<typename detail::source_for<A>::scalar>> time,
                    rounding mode = rounding::nearest) {
    const auto x = detail::source_of(a);
    const auto y = detail::source_of(b);
    detail::require_size(x, y, time.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
        detail::of_pair(i, [&] { time[i] = detail::rounded_impact(x.at(i), y.at(i), mode); });
    }
}

} // namespace batch
} // namespace graze::inline v0_1
