// How a run numbers the parts of its scene.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// A ball, plane or wall of a run: the balls first, then the planes, then the walls.
using body = std::uint32_t;
inline constexpr body no_body = 0xffffffffU;

// Whole periods along each axis.
using whole_periods = std::array<std::int32_t, 3>;

// Which image of a body, in whole periods along each axis from where it would be if nothing had ever been brought back
// by a period. Zeros in a scene without periods. Two axes share a word, so that one sum adds both and an index fits two
// registers.
class image_index {
  public:
    constexpr image_index() = default;
    constexpr image_index(const whole_periods& x) noexcept
        : first_two_(extended(x[0]) + (extended(x[1]) << 32)), third_(extended(x[2])) {}
    [[nodiscard]] constexpr std::int32_t operator[](std::size_t axis) const noexcept {
        return static_cast<std::int32_t>(axis == 2   ? third_
                                         : axis == 0 ? first_two_
                                                     : (first_two_ - extended((*this)[0])) >> 32);
    }
    [[nodiscard]] constexpr operator whole_periods() const noexcept { return {(*this)[0], (*this)[1], (*this)[2]}; }

    [[nodiscard]] friend constexpr image_index operator+(image_index x, image_index y) noexcept {
        x.first_two_ += y.first_two_;
        x.third_ += y.third_;
        return x;
    }
    [[nodiscard]] friend constexpr image_index operator-(image_index x, image_index y) noexcept {
        x.first_two_ -= y.first_two_;
        x.third_ -= y.third_;
        return x;
    }
    [[nodiscard]] friend constexpr bool operator==(image_index x, image_index y) noexcept {
        return ((x.first_two_ ^ y.first_two_) | (x.third_ ^ y.third_)) == 0;
    }
    [[nodiscard]] friend constexpr auto operator<=>(image_index x, image_index y) noexcept {
        return whole_periods(x) <=> whole_periods(y);
    }

  private:
    [[nodiscard]] static constexpr std::uint64_t extended(std::int32_t x) noexcept {
        return static_cast<std::uint64_t>(std::int64_t{x});
    }
    std::uint64_t first_two_ = 0, third_ = 0;
};

// A plane, wall or triangle, or that image of it, counted as in `predicted`.
struct standing_image {
    body what = no_body;
    image_index image{};
    [[nodiscard]] constexpr bool is_any() const noexcept { return what != no_body; }
    bool operator==(const standing_image&) const = default;
};

// Of more balls what is needed next is fetched from memory while something else is done.
inline constexpr std::size_t fit_into_cache = 4000;

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
