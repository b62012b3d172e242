// classify for exact number types (rationals, integers of any library). It evaluates the formulas as they are; in
// these types their signs are exact.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/formula/solve_flat.hpp>
#include <graze/pair/flat_stages.hpp>
#include <graze/pair/input_check.hpp>

#include <concepts>

namespace graze::inline v0_1 {

namespace detail {

// inspect for exact numbers, all of which are finite.
template <int N, exact_number T, class Tell>
constexpr void inspect_numbers(const ball<N, T>& b, Tell tell) {
    if (graze::sign(b.radius) < 0) {
        tell("radius", "radius is negative");
    }
}
template <int N, exact_number T, class Tell>
constexpr void inspect_numbers(const plane<N, T>& p, Tell tell) {
    if (graze::sign(graze::squared_norm(p.normal)) == 0) {
        tell("normal", "normal is zero");
    }
}
template <class Edged, class Tell>
requires requires(const Edged& x) { x.edge; }
constexpr void inspect_numbers(const Edged& x, Tell tell) {
    for (const auto& e : x.edge) {
        if (graze::sign(graze::squared_norm(e)) == 0) {
            tell("edge", "edge is zero");
        }
    }
}

// Whether sums and products of T have the type T again.
template <class T>
concept closed_number = std::same_as<std::remove_cvref_t<decltype(std::declval<T>() * std::declval<T>())>, T> &&
    std::same_as<std::remove_cvref_t<decltype(std::declval<T>() + std::declval<T>())>, T>;

template <int B>
[[nodiscard]] constexpr big_integer big(workspace& room, const integer<B>& x) {
    const integer<B> magnitude = x.is_negative() ? -x : x;
    big_integer sum(0);
    for (int i = 0; 32 * i < B; ++i) {
        const std::uint64_t half = magnitude.limb(i / 2) >> (i % 2 * 32) & 0xffffffffU;
        sum = sum + big_integer::from_shifted(room, static_cast<std::int64_t>(half), 32 * i);
    }
    return x.is_negative() ? -sum : sum;
}
template <int N, int B>
[[nodiscard]] constexpr vec<N, big_integer> big(workspace& room, const vec<N, integer<B>>& x) {
    return make_vec<N>([&](int i) { return big(room, x[i]); });
}

// Answers the questions of flat_decision in an exact type.
struct exact_number_judge {
    static constexpr bool has_roots = false;

    template <class F, class X>
    [[nodiscard]] constexpr int operator()(F f, const X& x) const {
        return graze::sign(f(x));
    }
};

// For a wall or a triangle. use(way, decision)
template <int N, class T, class Shape, class F>
[[nodiscard]] constexpr auto with_decision(const ball<N, T>& b, const Shape& s, F use) {
    const auto decide = [&]<class X, class Judge>(const flat_motion<N, X>& m, const Judge& judge) {
        const auto way = way_of(m);
        return use(way, flat_decision<N, X, Judge>(m, way, judge));
    };
    if constexpr (closed_number<T>) {
        return decide(flat_motion_of(b, s), exact_number_judge{});
    } else {
        exact_workspace room;
        flat_motion<N, big_integer> m{big(room, b.position) - big(room, s.corner),
                                      big(room, b.velocity),
                                      {},
                                      big(room, b.radius),
                                      is_triangle<Shape>};
        for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(N); ++i) {
            m.e[i] = big(room, s.edge[i]);
        }
        return decide(m, exact_judge{&room});
    }
}

template <int N, class T, class Shape>
[[nodiscard]] constexpr wall_encounter decide_in_numbers(const ball<N, T>& b, const Shape& s) {
    inspect_numbers(b, rejecting{"ball"});
    inspect_numbers(s, rejecting{name_of(s)});
    return with_decision(b, s, [&](const auto& way, const auto& decision) {
        if (graze::sign(way.nn) == 0) {
            tell_parallel_edges(rejecting{name_of(s)});
        }
        const flat_answer found = decision();
        return wall_encounter{found.what, found.where, found.index};
    });
}

} // namespace detail

// The exact encounter of a pair. Throws std::domain_error for a negative radius, a zero normal, a zero edge or parallel
// edges.
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<N, T>& a, const ball<N, T>& b) {
    detail::inspect_numbers(a, detail::rejecting{"ball a"});
    detail::inspect_numbers(b, detail::rejecting{"ball b"});
    const auto m = relative_motion_of(a, b);
    const auto q = quadratic_of(m);
    return encounter_of([&] { return graze::sign(q.h); }, [&] { return graze::sign(q.c); },
                        [&] { return graze::sign(discriminant_halved{}(q)); });
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<N, T>& b, const plane<N, T>& p) {
    detail::inspect_numbers(b, detail::rejecting{"ball"});
    detail::inspect_numbers(p, detail::rejecting{"plane"});
    const auto m = relative_motion_of(b, p);
    return encounter_of([&] { return graze::sign(plane_height{}(m)) * graze::sign(plane_speed{}(m)); },
                        [&] { return graze::sign(plane_clearance{}(m)); }, [] { return 1; });
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<N, T>& b, const wall<N, T>& w) {
    return detail::decide_in_numbers(b, w).what;
}
template <exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr encounter classify(const ball<3, T>& b, const triangle<T>& t) {
    return detail::decide_in_numbers(b, t).what;
}

// The encounter and its feature, as classify_feature gives them for doubles.
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr wall_encounter
    classify_feature(const ball<N, T>& b, const plane<N, T>& p) {
    return {classify(b, p), feature::face, 0};
}
template <int N, exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr wall_encounter
    classify_feature(const ball<N, T>& b, const wall<N, T>& w) {
    return detail::decide_in_numbers(b, w);
}
template <exact_number T>
requires(!is_binary_input<T>) [[nodiscard]] constexpr wall_encounter
    classify_feature(const ball<3, T>& b, const triangle<T>& t) {
    return detail::decide_in_numbers(b, t);
}

// In an inexact type without a proven filter, the formulas promise nothing.
template <int N, number T, class Other>
requires(!is_binary_input<T> && !exact_number<T>) constexpr encounter classify(const ball<N, T>&, const Other&) {
    static_assert(is_binary_input<T>,
                  "graze::classify decides exactly, for float, double, std::int32_t, std::int64_t and exact "
                  "number types; for the formulas in another inexact type call graze::solve");
    return encounter::recede;
}

} // namespace graze::inline v0_1
