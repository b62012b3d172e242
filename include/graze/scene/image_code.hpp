// Which image of a body is on a list, in one word.
#pragma once

#include <graze/scene/body.hpp>

#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// Few whole periods along each axis, as x + 2^10 y + 2^20 z modulo 2^32: 0 stands for none, -n for those back, and a
// sum for the sum.
using image_code = std::uint32_t;

inline constexpr std::int32_t most_periods = 100;
[[nodiscard]] constexpr image_code coded_along(std::int32_t periods, std::size_t axis) noexcept {
    return static_cast<image_code>(periods) << (10 * axis);
}
[[nodiscard]] constexpr image_code coded(const whole_periods& x) noexcept {
    return coded_along(x[0], 0) + coded_along(x[1], 1) + coded_along(x[2], 2);
}
// With 512 added along each axis, no axis borrows from the next one.
[[nodiscard]] constexpr std::int32_t decoded_along(image_code x, std::size_t axis) noexcept {
    constexpr image_code half = 512;
    return static_cast<std::int32_t>((x + half + (half << 10) + (half << 20)) >> (10 * axis) & 1023) - 512;
}
[[nodiscard]] constexpr image_index decoded(image_code x) noexcept {
    return whole_periods{decoded_along(x, 0), decoded_along(x, 1), decoded_along(x, 2)};
}

} // namespace graze::inline v0_1::detail
