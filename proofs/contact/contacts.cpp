// Contacts and rounded times as constants: results known by hand, ties, and every encounter.
#include <graze/collide.hpp>
#include <graze/time/time_of_shapes.hpp>

#include <cstdint>
#include <limits>

namespace {

using namespace graze;

constexpr double ulp = 0x1p-52;

template <class... T>
constexpr auto point(T... x) {
    return vec<sizeof...(T), double>{{static_cast<double>(x)...}};
}

// Equal masses head-on: time, places, and velocities exchanged.
constexpr auto head_on = *collide(ball<2>{{0, 0}, {1, 0}, 1}, ball<2>{{10, 0}, {-1, 0}, 1});
static_assert(head_on == contact<2>{4, point(4, 0), point(6, 0), point(-1, 0), point(-1, 0), point(1, 0)});

// With the normal (-3, -4)/5, masses 1 and 3, in space: a loses 3/2 and b gains 1/2 of the closing speed along it.
constexpr auto oblique = *collide(ball<3>{{0, 0, 0}, {10, 0, 0}, 2, 1}, ball<3>{{13, 4, 0}, {0, 0, 0}, 3, 3});
static_assert(oblique.time == 1 && oblique.position_a == point(10, 0, 0) && oblique.normal == point(-0.6, -0.8, 0));
static_assert(oblique.velocity_a == point(4.6, -7.2, 0) && oblique.velocity_b == point(1.8, 2.4, 0));

// Overlapping and touching have the time 0. Nothing moves a ball of infinite mass.
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto inside = *collide(ball<2>{{0, 0}, {1, 0}, 1, 2}, ball<2>{{1, 0}, {0, 0}, 1, infinity});
static_assert(inside == contact<2>{0, point(0, 0), point(1, 0), point(-1, 0), point(-1, 0), point(0, 0)});
static_assert(collide(ball<2>{{-1, 0}, {1, 0}, 1}, ball<2>{{1, 0}, {0, 0}, 1})->time == 0);

// A graze changes no velocity. Pairs that recede or miss have no contact.
constexpr auto grazed = *collide(ball<2>{{0, 0}, {1, 0.5}, 1}, ball<2>{{10, 2}, {-1, 0.5}, 1});
static_assert(grazed.time == 5 && grazed.normal == point(0, -1) && grazed.velocity_a == point(1, 0.5));
static_assert(!collide(ball<2>{{0, 0}, {-1, 0}, 1}, ball<2>{{10, 0}, {0, 0}, 1}));
static_assert(!collide(ball<2>{{0, 0}, {1, 0}, 1}, ball<2>{{10, 2 + 2 * ulp}, {0, 0}, 1}));

// τ = 1 + 2^-53, a tie; √3/2, √2/2 and 1/3 rounded, in doubles and floats.
constexpr auto tie = *time_of_impact(ball<2>{{1 + ulp, 0}, {-1, 0}, ulp / 2}, ball<2>{{0, 0}, {0, 0}, 0});
static_assert(static_cast<double>(tie) == 1 && tie.lower() == 1 && tie.upper() == 1 + ulp);
constexpr auto irrational = *collide(ball<2>{{-2, 0.5}, {1, 0}, 1}, ball<2>{{0, 0}, {0, 0}, 0});
static_assert(irrational.normal == point(-0x1.bb67ae8584caap-1, 0.5));
constexpr auto third = *collide(ball<2, float>{{0, 2}, {0, -3}, 1}, plane<2, float>{{0, 0}, {0, -7}});
static_assert(third.time == 0x1.555556p-2F && third.point == vec<2, float>{0, 0} && third.velocity[1] == 3);
constexpr auto diagonal = *collide(ball<2>{{0, 2}, {0, -1}, 1}, plane<2>{{0, 0}, {3, 3}});
static_assert(diagonal.normal == point(0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1));
static_assert(diagonal.velocity == point(1, 0));
constexpr auto slanted = *collide(ball<2>{{0, 5}, {3, -1}, 2}, plane<2>{{7, 0}, {0, 2}});
static_assert(slanted == wall_contact<2>{3, point(9, 2), point(9, 0), point(0, 1), point(3, 1), feature::face});
constexpr auto sunk = *collide(ball<2>{{4, 1}, {3, -1}, 2}, plane<2>{{7, 0}, {0, 2}});
static_assert(sunk == wall_contact<2>{0, point(4, 1), point(4, 0), point(0, 1), point(3, 1), feature::face});

// A wall's face, an edge and a corner.
constexpr wall<3> square{{5, -3, -3}, {{{{0, 6, 0}}, {{0, 0, 6}}}}};
constexpr auto against(double y, double z, double r) { return *collide(ball<3>{{0, y, z}, {1, 0, 0}, r}, square); }
static_assert(against(3, 3, 2) ==
              wall_contact<3>{3, point(3, 3, 3), point(5, 3, 3), point(-1, 0, 0), point(-1, 0, 0), feature::face});
static_assert(against(7, 1, 5) == wall_contact<3>{2, point(2, 7, 1), point(5, 3, 1), point(-0.6, 0.8, 0),
                                                  point(0.28, 0.96, 0), feature::edge, 1});
static_assert(against(5, 4, 3) == wall_contact<3>{3, point(3, 5, 4), point(5, 3, 3), point(-2. / 3, 2. / 3, 1. / 3),
                                                  point(1. / 9, 8. / 9, 4. / 9), feature::corner, 3});

// Times of integers are rounded to doubles: 10/3; and (2^62 - 1)/3, of 61 bits.
constexpr auto of_integers =
    *time_of_impact(ball<2, std::int32_t>{{0, 0}, {1, 0}, 1}, ball<2, std::int32_t>{{12, 0}, {-2, 0}, 1});
static_assert(static_cast<double>(of_integers) == 10. / 3 && of_integers < of_integers.upper());
constexpr auto far = *time_of_impact(ball<2, std::int64_t>{{std::int64_t{1} << 62, 5}, {-3, 0}, 1},
                                     plane<2, std::int64_t>{{0, 0}, {9, 0}});
static_assert(far == std::int64_t{0x1555555555555555} && far.upper() == 0x1.5555555555556p60);
static_assert(static_cast<double>(far) == 0x1.5555555555555p60 && far.lower() == 0x1.5555555555555p60);

// Results at the ends of the range.
static_assert(collide(ball<2>{{0x1p-1072, 0}, {-2, 0}, 0x1p-1074}, ball<2>{{0, 0}, {0, 0}, 0})->time == 0x1p-1073);
static_assert(static_cast<float>(*time_of_impact(ball<2, float>{{0x1p100F, 0}, {-0x1p-40F, 0}, 0},
                                                 plane<2, float>{{0, 0}, {1, 0}})) ==
              std::numeric_limits<float>::infinity());

} // namespace
