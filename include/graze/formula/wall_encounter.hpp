// The encounter of a ball with a wall or a triangle, and its feature.
#pragma once

#include <graze/formula/encounter.hpp>

namespace graze::inline v0_1 {

enum class feature { face, edge, corner };

[[nodiscard]] constexpr const char* to_string(feature f) noexcept {
    return f == feature::face ? "face" : f == feature::edge ? "edge" : "corner";
}

// index: in space that of an edge at λ_i = far is 2i + far, and a corner's is λ_0 + 2 λ_1; of a triangle edge 1 is the
// one at λ_0 + λ_1 = 1, in the place of that at λ_0 = 1, and corners are 0, 1 and 2. In the plane a corner's is λ_0. A
// face's is 0. For an overlap the feature is the closest one at t = 0; for recede and miss it means nothing, but for
// recede in graze::solve, which names the closest one too.
struct wall_encounter {
    encounter what;
    feature where;
    int index;

    [[nodiscard]] friend constexpr bool operator==(const wall_encounter&, const wall_encounter&) = default;
};

} // namespace graze::inline v0_1
