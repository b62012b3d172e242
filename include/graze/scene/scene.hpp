// Many balls, planes and walls.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

#include <span>

namespace graze::inline v0_1 {

// What moves and what stands, all given at t = 0, in one unit of length and one of time. Owns nothing: the spans must
// stay valid while the scene is used. Every part may be empty.
template <int N, class T = double>
struct scene {
    std::span<const ball<N, T>> balls{};
    std::span<const plane<N, T>> planes{};
    std::span<const wall<N, T>> walls{};
};

} // namespace graze::inline v0_1
