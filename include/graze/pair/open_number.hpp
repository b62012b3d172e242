// A number that inexact stages leave open, where it can still be told to be 0.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/formula/encounter.hpp>

namespace graze::inline v0_1::detail {

// h, c or D of two movers, and a number above its magnitude, if one is known, in units of 2^length and 2^velocity.
struct open_number {
    enum name { h, c, discriminant };

    name which = h;
    double limit = 0;
    int length = 0, velocity = 0;

    // Whether it is 0 for lengths that are integers times 2^of_lengths and velocities times 2^of_velocities: it is then
    // an integer, too, in a unit of its own, and none but 0 is below one unit.
    [[nodiscard]] constexpr bool is_zero(int of_lengths, int of_velocities) const noexcept {
        const int by_length = of_lengths - length;
        const int by_velocity = of_velocities - velocity;
        const int unit = which == h ? by_length + by_velocity : 2 * (which == c ? by_length : by_length + by_velocity);
        return limit > 0 && unit > -1000 && limit <= power_of_two(unit < 1000 ? unit : 1000);
    }
    // What the movers do then. c and D are asked for where h < 0, D where c > 0: of those that touch D = h².
    [[nodiscard]] constexpr encounter if_zero() const noexcept {
        return which == h ? encounter::recede : which == c ? encounter::hit : encounter::graze;
    }
};

} // namespace graze::inline v0_1::detail
