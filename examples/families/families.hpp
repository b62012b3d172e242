// Families of hard pairs, as doubles: the pairs that collision code gets wrong, sorted by cause.
//
// Only integers are random, and there is no floating-point operation. So a seed gives the same pairs on every platform,
// in any rounding mode and with any compiler flags. Needs only the standard library and graze's shapes.
#pragma once

#include "contact_families.hpp"
#include "grazing_families.hpp"
#include "range_families.hpp"
#include "time_families.hpp"
#include "wall_families.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace families {

// Pair number `index` of a seed. Any index may be drawn alone.
template <int N>
using generator = pair_of_doubles<N> (*)(std::uint64_t seed, std::uint64_t index);

struct family {
    std::string_view name;
    std::string_view what_makes_it_hard;
    std::string_view hardness; // what the pairs' k means, or empty
    generator<2> in_the_plane;
    generator<3> in_space;

    template <int N>
    [[nodiscard]] constexpr pair_of_doubles<N> draw(std::uint64_t seed, std::uint64_t index) const {
        if constexpr (N == 2) {
            return in_the_plane(seed, index);
        } else {
            return in_space(seed, index);
        }
    }
};

inline constexpr std::array all_families{
    family{"generic", "Nothing special: what rounding alone loses.", "", generic<2>, generic<3>},
    family{"grazing", "The balls barely touch or barely miss, by a fraction 2^-k of R.",
           "(R² - m²)/R² is ±2^-k, m the least distance", grazing<2>, grazing<3>},
    family{"tangent", "The discriminant is exactly 0, or would be but for one unit in the last place.", "", tangent<2>,
           tangent<3>},
    family{"far", "The balls are 2^k radii apart: the discriminant is a small difference of large products.",
           "distance/R is 2^k", far<2>, far<3>},
    family{"tiny_radii", "The radii are below the last bit of the distance, or 0.", "distance/R is 2^k", tiny_radii<2>,
           tiny_radii<3>},
    family{"near_contact", "The gap is a fraction 2^-k of the radii, so that |Δx|² - R² cancels.", "gap/R is 2^-k",
           near_contact<2>, near_contact<3>},
    family{"touching", "The gap is exactly 0, or would be but for one unit in the last place.", "", touching<2>,
           touching<3>},
    family{"after_bounce", "The balls move apart, but rounding has left about half of them overlapping.", "",
           after_bounce<2>, after_bounce<3>},
    family{"rounded_radius_sum", "The sum of the radii is no double, and the nearest double gives another answer.", "",
           rounded_radius_sum<2>, rounded_radius_sum<3>},
    family{"common_part",
           "Positions and velocities are large beside their differences, or the differences must be rounded.",
           "grazing to 2^-k (even) or a common part of 2^k (odd pairs)", common_part<2>, common_part<3>},
    family{"almost_equal_velocities", "The velocities agree in their first k bits.", "|u|/|Δu| is 2^k",
           almost_equal_velocities<2>, almost_equal_velocities<3>},
    family{"equal_times", "Pairs 2i and 2i + 1 collide at the same time, or a unit in the last place apart.", "",
           equal_times<2>, equal_times<3>},
    family{"ties", "The time is exactly a double, exactly midway between two, or just beside.", "", ties<2>, ties<3>},
    family{"edges_and_corners", "The least distance from a wall's edge or corner is r(1 ± 2^-k).",
           "the least distance is r(1 ± 2^-k)", edges_and_corners<2>, edges_and_corners<3>},
    family{"borders", "The wall is touched where its face or an edge ends, or just beside.", "", borders<2>,
           borders<3>},
    family{"two_walls", "Pairs 2i and 2i + 1 are the two sides of a wedge, which the ball meets at the same time.", "",
           two_walls<2>, two_walls<3>},
    family{"generic_wall", "Nothing special, against walls and planes: what rounding alone loses.", "", generic_wall<2>,
           generic_wall<3>},
    family{"scaled", "Everything is multiplied by 2^±500: squares overflow or vanish.", "", scaled<2>, scaled<3>},
    family{"subnormal", "Lengths, or all numbers, are subnormal: products vanish.", "", subnormal<2>, subnormal<3>},
    family{"own_exponents", "Every coordinate has an exponent of its own.", "", own_exponents<2>, own_exponents<3>},
    family{"masses", "One mass is infinite or 2^k times as large as the other.", "the masses' ratio is 2^k", masses<2>,
           masses<3>},
};

// Null if no family has that name.
[[nodiscard]] constexpr const family* find_family(std::string_view name) {
    for (const family& f : all_families) {
        if (f.name == name) {
            return &f;
        }
    }
    return nullptr;
}

} // namespace families
