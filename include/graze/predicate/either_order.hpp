// A plane, wall or triangle as the first argument and a ball or flight as the second.
#pragma once

#include <graze/pair/mismatch.hpp>
#include <graze/pair/pair.hpp>

namespace graze::inline v0_1 {

// The answers do not depend on the order of the arguments.
template <detail::standing Shape, class Ball, class... Observer>
requires(!detail::standing<Ball> && !detail::mismatched<Shape, Ball>)
    [[nodiscard]] constexpr auto classify(const Shape& shape, const Ball& b, Observer&&... observer) {
    return classify(b, shape, observer...);
}
template <detail::standing Shape, class Ball, class... Observer>
requires(!detail::standing<Ball> && !detail::mismatched<Shape, Ball>)
    [[nodiscard]] constexpr auto classify_feature(const Shape& shape, const Ball& b, Observer&&... observer) {
    return classify_feature(b, shape, observer...);
}
template <detail::standing Shape, class Ball, class... Observer>
requires(!detail::standing<Ball> && !detail::mismatched<Shape, Ball>)
    [[nodiscard]] constexpr bool overlaps(const Shape& shape, const Ball& b, Observer&&... observer) {
    return overlaps(b, shape, observer...);
}
template <detail::standing Shape, class Ball, class... Observer>
requires(!detail::standing<Ball> && !detail::mismatched<Shape, Ball>)
    [[nodiscard]] constexpr auto time_of_impact(const Shape& shape, const Ball& b, Observer&&... observer) {
    return time_of_impact(b, shape, observer...);
}
template <detail::standing Shape, class Ball, class... Observer>
requires(!detail::standing<Ball> && !detail::mismatched<Shape, Ball>)
    [[nodiscard]] constexpr auto collide(const Shape& shape, const Ball& b, Observer&&... observer) {
    return collide(b, shape, observer...);
}

} // namespace graze::inline v0_1
