// Decisions and times as constants: every encounter, exact ties, and inputs one unit in the last place away from them.
#include <graze/graze.hpp>

#include <cstdint>

namespace {

using namespace graze;

constexpr double ulp = 0x1p-52;

// Ball against ball: Δu = (-2, 0), R = 2, passing at height y.
constexpr encounter pass(double y) { return classify(ball<2>{{0, 0}, {1, 0}, 1}, ball<2>{{10, y}, {-1, 0}, 1}); }
static_assert(pass(2) == encounter::graze);
static_assert(pass(2 - ulp) == encounter::hit);
static_assert(pass(2 + 2 * ulp) == encounter::miss);
static_assert(classify(ball<2>{{0, 0}, {1, 0}, 1}, ball<2>{{1, 0}, {0, 0}, 1}) == encounter::overlap);
static_assert(classify(ball<2>{{0, 0}, {-1, 0}, 1}, ball<2>{{1, 0}, {0, 0}, 1}) == encounter::recede);
static_assert(overlaps(ball<2>{{0, 0}, {-1, 0}, 1}, ball<2>{{1, 0}, {0, 0}, 1}));

// The same in integers, and in floats.
static_assert(classify(ball<3, std::int32_t>{{0, 0, 0}, {1, 0, 0}, 1},
                       ball<3, std::int32_t>{{9, 2, 0}, {0, 0, 0}, 1}) == encounter::graze);
static_assert(classify(ball<3, std::int64_t>{{0, 0, 0}, {1, 0, 0}, 1},
                       ball<3, std::int64_t>{{9, 2, 0}, {0, 0, 0}, 1}) == encounter::graze);
static_assert(classify(ball<2, float>{{0, 0}, {1, 0}, 1}, ball<2, float>{{9, 0x1.000002p1F}, {0, 0}, 1}) ==
              encounter::miss);

// A wall's face, edge and corner, met exactly at their borders.
constexpr wall<3> square{{5, -3, -3}, {{{{0, 6, 0}}, {{0, 0, 6}}}}};
constexpr encounter against(double y, double z) { return classify(ball<3>{{0, y, z}, {1, 0, 0}, 5}, square); }
static_assert(against(3, 3) == encounter::hit);
static_assert(against(8, 0) == encounter::graze);
static_assert(against(8 - 4 * ulp, 0) == encounter::hit);
static_assert(against(6, 7) == encounter::graze); // (3, 4, 5) from the corner
static_assert(against(6, 7 + 4 * ulp) == encounter::miss);

// Times: exact equality across kinds, and against doubles.
constexpr auto with_wall = *time_of_impact(ball<3>{{0, 0, 0}, {1, 0, 0}, 1}, square);
constexpr auto with_plane = *time_of_impact(ball<3>{{0, 0, 0}, {1, 0, 0}, 1}, plane<3>{{5, 0, 0}, {-3, 0, 0}});
constexpr auto with_ball = *time_of_impact(ball<3>{{0, 0, 0}, {1, 0, 0}, 1}, ball<3>{{6, 0, 0}, {0, 0, 0}, 1});
static_assert(with_wall == with_plane && with_plane == with_ball && with_ball == 4.0);
static_assert(with_wall < 4 + 4 * ulp && with_wall > 4 - 2 * ulp);

// A time exactly between two doubles, 1 + 2^-53: it compares rightly with both.
constexpr auto between = *time_of_impact(ball<2>{{1 + ulp, 0}, {-1, 0}, 0x1p-54}, ball<2>{{0, 0}, {0, 0}, 0x1p-54});
static_assert(between > 1.0 && between < 1 + ulp);

// An edge's irrational time, met from two sides at once.
constexpr auto from_below = *time_of_impact(ball<3>{{0, -3.5, 0}, {1, 0, 0}, 1}, square);
constexpr auto from_above = *time_of_impact(ball<3>{{0, 3.5, 0}, {1, 0, 0}, 1}, square);
static_assert(from_below == from_above && from_below > 4.1339745962155 && from_below < 4.1339745962156);

} // namespace
