// The source's misprints: each printed form refuted by an example, the corrected one holding there.
#include <graze/formula/solve.hpp>
#include <graze/number/floating.hpp>
#include <graze/number/integer.hpp>

namespace {

using namespace graze;
using number = integer<40>;

// (12) without its parentheses: Δx = (10, 2.2), Δu = (-2, 0), R = 3, lengths in tenths. The balls collide.
constexpr relative_motion<2, number, number, number> collide{{{100, 22}}, {{-20, 0}}, 30};
constexpr auto q = quadratic_of(collide);
constexpr auto printed = q.h * q.h - (q.a * squared_norm(collide.dx) - collide.R * collide.R);
static_assert(sign(printed) < 0, "the printed (12) says that they do not meet");
static_assert(sign(discriminant_halved{}(q)) > 0, "corrected, it says that they do");
static_assert(sign(discriminant_lagrange{}(collide)-discriminant_halved{}(q)) == 0, "Lagrange's identity");
static_assert(sign(discriminant_textbook{}(q)-twice(twice(discriminant_halved{}(q)))) == 0, "b² - 4ac = 4D");

// (12) is not enough: parting balls have real roots too.
constexpr ball<2> left{{-2, 0}, {-1, 0}, 1};
constexpr ball<2> right{{2, 0}, {1, 0}, 1};
static_assert(solve(left, right).discriminant > 0 && solve(left, right).what == encounter::recede);

// (2): Δx points from b to a, and so does the normal; (21): α is negative for balls that approach.
constexpr ball<2> a{{0, 0}, {1, 0}, 1, 1};
constexpr ball<2> b{{10, 0}, {-1, 0}, 1, 1};
constexpr auto s = solve(a, b);
static_assert(relative_motion_of(a, b).dx[0] == -10 && s.normal[0] == -1);
static_assert(impulse(reduced_mass(1.0, 1.0), s.normal, relative_motion_of(a, b).du) < 0);

// (18): with the sign that (17) gives its right side it holds; as printed it does not.
constexpr ball<2> slow{{10, 0}, {-1, 0}, 1, 1};
constexpr auto t = solve<variant::lagrange>(ball<2>{{0, 0}, {2, 0}, 1, 1}, slow);
constexpr double of_a = (2 - t.velocity_a[0]) * (2 + t.velocity_a[0]);
constexpr double of_b = (-1 - t.velocity_b[0]) * (-1 + t.velocity_b[0]);
static_assert(of_a == -of_b && of_a != of_b);

// (33) as printed is when the centre arrives; the ball touches earlier.
constexpr ball<2> towards{{0, 0}, {1, 0}, 1};
constexpr plane<2> far_plane{{7, 0}, {-2, 0}};
static_assert(solve(towards, far_plane).time == 6);
static_assert(centre_crossing_time{}(plane_height{}(relative_motion_of(towards, far_plane)),
                                     plane_speed{}(relative_motion_of(towards, far_plane))) == 7);

} // namespace
