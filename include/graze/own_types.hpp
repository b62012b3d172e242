// classify, overlaps, time_of_impact, collide and solve for shapes of users' own types: ball_access, plane_access,
// wall_access or triangle_access reads the shapes, vector_access their vectors.
#pragma once

#include <graze/classify.hpp>
#include <graze/collide.hpp>
#include <graze/overlaps.hpp>
#include <graze/shape/shape_access.hpp>
#include <graze/solve.hpp>
#include <graze/time_of_impact.hpp>

#include <utility>

namespace graze::inline v0_1 {

// Two shapes, at least one of them a user's.
template <class A, class B>
concept foreign_pair = (foreign_shape<A> && (foreign_shape<B> || own_shape<B>)) || (own_shape<A> && foreign_shape<B>);

namespace detail {

struct decided_foreign {
    encounter what;
    stage decided_by;
};

// The shapes are made here, for the few pairs that the filter leaves open.
template <class A, class B>
[[nodiscard, gnu::noinline]] constexpr decided_foreign classify_foreign(const A& a, const B& b) {
    decided_foreign r{};
    r.what = classify(shape_of(a), shape_of(b), [&](stage s) { r.decided_by = s; });
    return r;
}

// Two balls of one floating-point type, or two flights.
template <class A, class B>
concept filtered_pair = ball_like<A> && ball_like<B> && requires(const A& a, const B& b) {
    { shape_of(a) } -> std::same_as<decltype(shape_of(b))>;
} && std::floating_point<number_in<decltype(shape_of(std::declval<const A&>()))>>;

} // namespace detail

// The answer, stage and errors are those of the function of the same name for shape_of(a) and shape_of(b).
template <class A, class B, class Observer = ignore_stage>
requires foreign_pair<A, B>
[[nodiscard, gnu::always_inline]] constexpr inline encounter classify(const A& a, const B& b,
                                                                      Observer&& observer = {}) {
    if constexpr (detail::filtered_pair<A, B>) {
        if (!std::is_constant_evaluated()) {
            if (const auto f = detail::filter_movers(shape_of(a), shape_of(b)); f.certain) [[likely]] {
                observer(stage::filter);
                return f.what();
            }
        }
    }
    const auto decided = detail::classify_foreign(a, b);
    observer(decided.decided_by);
    return decided.what;
}
template <class A, class B, class... Observer>
requires foreign_pair<A, B>
[[nodiscard, gnu::always_inline]] constexpr inline auto classify_feature(const A& a, const B& b,
                                                                         Observer&&... observer) {
    return classify_feature(shape_of(a), shape_of(b), std::forward<Observer>(observer)...);
}
template <class A, class B, class... Observer>
requires foreign_pair<A, B>
[[nodiscard, gnu::always_inline]] constexpr inline bool overlaps(const A& a, const B& b, Observer&&... observer) {
    return overlaps(shape_of(a), shape_of(b), std::forward<Observer>(observer)...);
}
template <class A, class B, class... Observer>
requires foreign_pair<A, B>
[[nodiscard, gnu::always_inline]] constexpr inline auto time_of_impact(const A& a, const B& b, Observer&&... observer) {
    return time_of_impact(shape_of(a), shape_of(b), std::forward<Observer>(observer)...);
}
template <class A, class B, class... Observer>
requires foreign_pair<A, B>
[[nodiscard, gnu::always_inline]] constexpr inline auto collide(const A& a, const B& b, Observer&&... observer) {
    return collide(shape_of(a), shape_of(b), std::forward<Observer>(observer)...);
}
template <variant V = variant::lagrange, class A, class B>
requires foreign_pair<A, B>
[[nodiscard]] constexpr auto solve(const A& a, const B& b) { return solve<V>(shape_of(a), shape_of(b)); }

} // namespace graze::inline v0_1
