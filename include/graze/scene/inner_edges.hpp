// Edges of a mesh at which nothing is met.
#pragma once

#include <graze/formula/wall_encounter.hpp>

namespace graze::inline v0_1::detail {

// Whether a triangle is met at an inner edge, or at a corner in which one ends. The mask says which edges are inner
// (bit k: edge k).
[[nodiscard]] constexpr bool is_inner(const wall_encounter& met, unsigned inner) noexcept {
    constexpr unsigned at_corner[3] = {0b101, 0b110, 0b011}; // edges 0 and 2, 1 and 2, 0 and 1
    const unsigned of = met.where == feature::edge     ? 1U << static_cast<unsigned>(met.index)
                        : met.where == feature::corner ? at_corner[met.index]
                                                       : 0;
    return is_collision(met.what) && (inner & of) != 0;
}

} // namespace graze::inline v0_1::detail
