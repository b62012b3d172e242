// How a run numbers the parts of its scene.
#pragma once

#include <array>
#include <cstdint>

namespace graze::inline v0_1::detail {

// A ball, plane or wall of a run: the balls first, then the planes, then the walls.
using body = std::uint32_t;
inline constexpr body no_body = 0xffffffffU;

// Which image of a body, in whole periods along each axis from where it would be if nothing had ever been brought back
// by a period. Zeros in a scene without periods.
using image_index = std::array<std::int32_t, 3>;

[[nodiscard]] constexpr image_index operator+(const image_index& x, const image_index& y) noexcept {
    return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}
[[nodiscard]] constexpr image_index operator-(const image_index& x, const image_index& y) noexcept {
    return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}

// Body a, a ball, meets that image of body b not before lower, unless one of the two has had another event since
// (counts).
struct predicted {
    double lower;
    body a;
    body b;
    std::uint32_t count_a;
    std::uint32_t count_b;
    image_index image{};
};

} // namespace graze::inline v0_1::detail
