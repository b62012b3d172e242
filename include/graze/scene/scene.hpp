// Many balls, planes, walls and triangles.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <cstdint>
#include <span>

namespace graze::inline v0_1 {

// What moves and what stands, all given at t = 0, in one unit of length and one of time. Owns nothing: the spans must
// stay valid while the scene is used. Every part may be empty.
//
// period: along an axis with period L > 0 the scene repeats itself for ever, every L; 0 is none. Each ball, wall and
// triangle is given by one of its images, and a ball meets the image that it meets first, whichever it is. No ball may
// be as wide as a period, no wall or triangle longer than one, and no plane's normal may have a component along one.
template <int N, class T = double>
struct scene {
    std::span<const ball<N, T>> balls{};
    std::span<const plane<N, T>> planes{};
    std::span<const wall<N, T>> walls{};
    vec<N, T> period = make_vec<N>([](int) { return T(0); });
};

// In space there are triangles too. inner_edges: empty, or for each triangle the sum of 2^k over its edges k along
// which another triangle goes on. Balls do not meet an inner edge or its corners: the seam of two triangles does not
// trip a ball that rolls over it, though its height was rounded.
template <class T>
struct scene<3, T> {
    std::span<const ball<3, T>> balls{};
    std::span<const plane<3, T>> planes{};
    std::span<const wall<3, T>> walls{};
    std::span<const triangle<T>> triangles{};
    std::span<const std::uint8_t> inner_edges{};
    vec<3, T> period = make_vec<3>([](int) { return T(0); });
};

namespace detail {

template <int N, class T>
[[nodiscard]] constexpr std::span<const triangle<T>> triangles_of(const scene<N, T>& s) noexcept {
    if constexpr (N == 3) {
        return s.triangles;
    } else {
        return {};
    }
}
template <int N, class T>
[[nodiscard]] constexpr std::span<const std::uint8_t> inner_edges_of(const scene<N, T>& s) noexcept {
    if constexpr (N == 3) {
        return s.inner_edges;
    } else {
        return {};
    }
}

} // namespace detail
} // namespace graze::inline v0_1
