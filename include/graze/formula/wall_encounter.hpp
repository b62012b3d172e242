// The encounter of a ball with a wall or a triangle, and its feature.
#pragma once

#include <graze/formula/encounter.hpp>

namespace graze::inline v0_1 {

enum class feature { face, edge, corner };

[[nodiscard]] constexpr const char* to_string(feature f) noexcept {
    return f == feature::face ? "face" : f == feature::edge ? "edge" : "corner";
}

// index: in space an edge at λ_i = far has 2i + far, and a corner λ_0 + 2 λ_1. A triangle's edge 1 is the one at λ_0 +
// λ_1 = 1, in place of that at λ_0 = 1, and its corners are 0, 1 and 2. In the plane a corner has λ_0. A face has 0.
// For an overlap the feature is the closest one at t = 0. For recede and miss it means nothing, except that
// graze::solve names the closest one for recede too.
struct wall_encounter {
    encounter what;
    feature where;
    int index;

    [[nodiscard]] friend constexpr bool operator==(const wall_encounter&, const wall_encounter&) = default;
};

} // namespace graze::inline v0_1
