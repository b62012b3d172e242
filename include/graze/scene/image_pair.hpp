// A ball and an image of something else in its scene, exactly.
#pragma once

#include <graze/pair/stand_in.hpp>
#include <graze/scene/body.hpp>
#include <graze/shape/ball.hpp>

#include <concepts>

namespace graze::inline v0_1::detail {

// f(a, b) for two that are as far from each other as x and that image of y. A plane is its own image. Throws
// std::range_error where numbers T cannot hold them.
template <int N, class T, class S, class F>
void with_image(const ball<N, T>& x, const S& y, image_index image, const vec<N, T>& period, F f) {
    const image_shift<N, T> shift{image, period};
    if (image == image_index{}) {
        f(x, y);
        return;
    }
    if constexpr (requires { y.edge; }) {
        f(x, displaced_exactly(y, shift));
    } else if constexpr (!std::same_as<S, ball<N, T>>) {
        f(x, y);
    } else if constexpr (std::floating_point<T>) {
        const stand_ins<N, T> pair({x, T(0)}, {y, T(0)}, shift);
        f(pair.a.state, pair.b.state);
    } else {
        ball<N, T> there = y;
        there.position = moved_exactly(y.position, shift);
        f(x, there);
    }
}

} // namespace graze::inline v0_1::detail
