// The encounters of many pairs, decided together.
#pragma once

#include <graze/pair/batch_blocks.hpp>
#include <graze/predicate/lane_balls.hpp>
#include <graze/predicate/lane_planes.hpp>
#include <graze/predicate/lane_walls.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>

#include <span>

namespace graze::inline v0_1 {

namespace detail {

struct batch_classify {
    using answer = encounter;
    template <class X, class Y>
    [[nodiscard]] static encounter one(const X& x, const Y& y) {
        return graze::classify(x, y);
    }
    // Pairs that the lanes leave open. Doubles have been through the filter, floats through one in float.
    template <class X, class Y>
    [[nodiscard]] static encounter further(const X& x, const Y& y) {
        return graze::classify(x, y);
    }
    template <int N>
    [[nodiscard]] static encounter further(const ball<N, double>& x, const ball<N, double>& y) {
        return classify_further(x, y).what;
    }
    template <int N, class V, class Y>
    requires requires(const ball<N, V>& x, const Y& y) { classify_lanes(x, y); }
    [[nodiscard, gnu::always_inline]] static lane_encounters<V> lanes(const ball<N, V>& x, const Y& y) noexcept {
        return classify_lanes(x, y);
    }
};

struct batch_overlaps {
    using answer = bool;
    template <class X, class Y>
    [[nodiscard]] static bool one(const X& x, const Y& y) {
        return graze::overlaps(x, y);
    }
    template <class X, class Y>
    [[nodiscard]] static bool further(const X& x, const Y& y) {
        return graze::overlaps(x, y);
    }
    template <int N, class V, class Y>
    requires requires(const ball<N, V>& x, const Y& y) { overlaps_lanes(x, y); }
    [[nodiscard, gnu::always_inline]] static lane_overlaps<V> lanes(const ball<N, V>& x, const Y& y) noexcept {
        return overlaps_lanes(x, y);
    }
};

} // namespace detail

namespace batch {

// The encounter of each ball of a with the ball of the same index in b, or with the one ball, plane, wall or triangle
// b: what[i] is classify(a[i], b[i]). a: a contiguous range of balls, or columns; so is b if it has one for each ball
// of a. Throws std::invalid_argument, before anything is written, if sizes differ. Bad input throws what classify
// throws, with a message that begins with "pair " and the first bad index; all answers before that one have then been
// written, and any of those after it may have been. Calls share nothing: several threads may ask parts of a batch.
template <class A, class B, class Mode = detail::unit_mode>
requires detail::batch_of<A, B>
void classify(const A& a, const B& b, std::span<encounter> what) {
    detail::decide_all<detail::batch_classify, Mode>(detail::source_of(a), detail::source_of(b), what);
}

// Whether the two of each pair are inside each other: inside[i] is overlaps(a[i], b[i]). All else as for classify.
template <class A, class B, class Mode = detail::unit_mode>
requires detail::batch_of<A, B>
void overlaps(const A& a, const B& b, std::span<bool> inside) {
    detail::decide_all<detail::batch_overlaps, Mode>(detail::source_of(a), detail::source_of(b), inside);
}

} // namespace batch
} // namespace graze::inline v0_1
