// Whole scenes as constants: exactly what a player expects of them. In doubles where every number is a double,
// otherwise in rationals and their square roots.
#include <graze/graze.hpp>

#include "../rational.hpp"

#include <array>

namespace {

using namespace graze;
using proof::rational;
using surd = sqrt_extension<rational>;

template <int N>
using exact_ball = ball<N, rational>;

// ---- An exact tangent, and an irrational hit.

constexpr exact_ball<2> lower{{{0, 0}}, {{1, 0}}, 2, 3};
constexpr exact_ball<2> upper{{{10, 3}}, {{-1, 0}}, 1, 5};
static_assert(classify(lower, upper) == encounter::graze);
static_assert(solve(lower, upper).time == surd(5));
static_assert(solve(lower, upper).velocity_a[0] == surd(1) && solve(lower, upper).normal[1] == surd(-1));

// ---- Conservation in Q(√D): momentum and energy, exactly.

template <int N>
constexpr surd kinetic(const vec<N, surd>& v, const rational& m) {
    return surd(m) * squared_norm(v);
}
template <int N>
constexpr bool conserves(const exact_ball<N>& a, const exact_ball<N>& b) {
    const auto s = solve(a, b);
    if (s.what != encounter::hit || sign(s.time.q()) == 0) {
        return false; // not with an irrational time
    }
    const auto u_a = detail::as<surd>(a.velocity);
    const auto u_b = detail::as<surd>(b.velocity);
    const vec<N, surd> before = surd(a.mass) * u_a + surd(b.mass) * u_b;
    const vec<N, surd> after = surd(a.mass) * s.velocity_a + surd(b.mass) * s.velocity_b;
    const rational R = a.radius + b.radius;
    return before == after && // (14)
           kinetic(u_a, a.mass) + kinetic(u_b, b.mass) ==
               kinetic(s.velocity_a, a.mass) + kinetic(s.velocity_b, b.mass) && // (16)
           squared_norm(s.position_a - s.position_b) == surd(R * R) &&          // (3), at contact
           squared_norm(s.normal) == surd(1) &&
           sign(dot(s.normal, u_a - u_b)) < 0 &&                                            // (20), (21)
           dot(s.normal, s.velocity_a - s.velocity_b) == -dot(s.normal, u_a - u_b) &&       // (22)
           dot(s.normal, u_a - u_b) == surd(rational(0), -rational(1) / R, s.discriminant); // -√D/R
}
static_assert(conserves(lower, exact_ball<2>{{{10, 2}}, {{-1, 0}}, 1, 5}));
static_assert(conserves(exact_ball<2>{{{1, 2}}, {{3, 1}}, 2, 7}, exact_ball<2>{{{9, 5}}, {{-1, -1}}, 1, 2}));
static_assert(conserves(exact_ball<3>{{{0, 0, 0}}, {{2, 1, 0}}, 1, 1}, exact_ball<3>{{{7, 3, 1}}, {{0, 0, 0}}, 1, 1}));
static_assert(conserves(exact_ball<3>{{{0, 0, 0}}, {{2, 1, -1}}, 2, rational(1, 3)},
                        exact_ball<3>{{{9, 1, 1}}, {{-1, 1, -1}}, 1, 4}));

// An infinite mass is not moved; the other keeps its speed.
constexpr auto against_the_earth = solve_with_inverse_masses(
    exact_ball<2>{{{0, 0}}, {{1, 0}}, 1}, exact_ball<2>{{{5, 1}}, {{0, 0}}, 1}, rational(2), rational(0));
static_assert(against_the_earth.velocity_b == detail::zero_vector<2, surd>() &&
              squared_norm(against_the_earth.velocity_a) == surd(1) && sign(against_the_earth.time.q()) != 0);

// Whatever the variant of D and the form of the root (which looks different over √(4D)), τ solves (10) and is the
// earlier root: the slope there is negative.
constexpr exact_ball<2> off_centre{{{10, 2}}, {{-1, 0}}, 1, 5};
template <variant V, root_form F>
constexpr bool solves_the_quadratic() {
    const auto q = quadratic_of(relative_motion_of(lower, off_centre));
    const surd t = solve<V, F>(lower, off_centre).time;
    return surd(q.a) * t * t + twice(surd(q.h) * t) + surd(q.c) == surd(0) && sign(surd(q.a) * t + surd(q.h)) < 0;
}
static_assert(solves_the_quadratic<variant::textbook, root_form::printed>());
static_assert(solves_the_quadratic<variant::halved, root_form::stable>());
static_assert(solves_the_quadratic<variant::lagrange, root_form::stable>());
static_assert(solve<variant::halved>(lower, off_centre).velocity_a == solve(lower, off_centre).velocity_a);
static_assert(solve<variant::textbook>(lower, off_centre).discriminant == solve(lower, off_centre).discriminant);

// Balls that overlap and approach are resolved now, along the line of centres.
constexpr auto inside = solve(exact_ball<2>{{{0, 0}}, {{1, 0}}, 2, 1}, exact_ball<2>{{{1, 1}}, {{0, 0}}, 1, 1});
static_assert(inside.what == encounter::overlap && inside.time == surd(0) && squared_norm(inside.normal) == surd(1) &&
              squared_norm(inside.velocity_a) + squared_norm(inside.velocity_b) == surd(1) &&
              inside.velocity_a[0] == surd(rational(1, 2)) && inside.velocity_b[1] == surd(rational(1, 2)));

// ---- A corner, an edge and a plane hit at irrational times: distance and speed are exact.

constexpr wall<3, rational> square{{{5, -3, -3}}, {{{{0, 6, 0}}, {{0, 0, 6}}}}};
constexpr auto corner = solve(exact_ball<3>{{{0, 4, 4}}, {{2, 0, 0}}, 2}, square);
static_assert(corner.what == encounter::hit && corner.where == feature::corner && corner.index == 3);
static_assert(corner.point == vec<3, surd>{{5, 3, 3}} && sign(corner.time.q()) != 0 && corner.discriminant == 8);
static_assert(squared_norm(corner.position - corner.point) == surd(4) && squared_norm(corner.normal) == surd(1));
static_assert(squared_norm(corner.velocity) == surd(4) &&
              dot(corner.velocity, corner.normal) == -surd(2) * corner.normal[0]);

constexpr auto edge = solve(exact_ball<3>{{{0, 4, 1}}, {{2, 0, 1}}, 2}, square);
static_assert(edge.what == encounter::hit && edge.where == feature::edge && edge.index == 1);
static_assert(edge.point[0] == surd(5) && edge.point[1] == surd(3) && edge.point[2] == edge.position[2] &&
              edge.normal[2] == surd(0) && sign(edge.time.q()) != 0);
static_assert(edge.discriminant == 12 * 36 * 36, "of distances across the edge, whose square is 36, it is 12");
static_assert(squared_norm(edge.position - edge.point) == surd(4) && squared_norm(edge.velocity) == surd(5) &&
              edge.velocity[2] == surd(1));

constexpr auto tilted =
    solve(exact_ball<3>{{{1, 1, 9}}, {{0, 1, -2}}, 2}, plane<3, rational>{{{0, 0, 0}}, {{1, 2, 2}}});
static_assert(tilted.what == encounter::hit && tilted.normal[0] == surd(rational(1, 3)));
static_assert(squared_norm(tilted.position - tilted.point) == surd(4) && squared_norm(tilted.velocity) == surd(5));
static_assert(tilted.point[0] + surd(2) * (tilted.point[1] + tilted.point[2]) == surd(0), "on the plane");
static_assert(tilted.where == feature::face && tilted.index == 0 && tilted.discriminant == rational(0));
constexpr auto sunk = solve(exact_ball<2>{{{3, 1}}, {{1, -1}}, 2}, plane<2, rational>{{{0, 0}}, {{0, 3}}});
static_assert(sunk.what == encounter::overlap && sunk.point[0] == surd(3) && sunk.point[1] == surd(0) &&
              sunk.normal[1] == surd(1) && sunk.velocity[1] == surd(1));
constexpr auto from_below =
    solve(exact_ball<2>{{{0, -5}}, {{1, 1}}, 1}, plane<2, rational>{{{0, 0}}, {{1, 2}}}); // |n| = √5
static_assert(from_below.what == encounter::hit && sign(from_below.time.q()) != 0 &&
              squared_norm(from_below.position - from_below.point) == surd(1) &&
              from_below.point[0] + surd(2) * from_below.point[1] == surd(0) &&
              squared_norm(from_below.velocity) == surd(2));

// A ball that cuts a face, an edge or a corner and gets deeper turns back at once.
constexpr auto in_face = solve(exact_ball<3>{{{4, 0, 0}}, {{1, 0, 0}}, 2}, square);
static_assert(in_face.what == encounter::overlap && in_face.time == surd(0) && in_face.velocity[0] == surd(-1) &&
              in_face.point[0] == surd(5) && in_face.normal == vec<3, surd>{{-1, 0, 0}});
constexpr auto in_corner = solve(exact_ball<3>{{{4, 4, 4}}, {{1, 0, 0}}, 2}, square);
static_assert(in_corner.what == encounter::overlap && in_corner.where == feature::corner &&
              squared_norm(in_corner.normal) == surd(1) && squared_norm(in_corner.velocity) == surd(1));

// ---- An exact tie of irrational times, between a collision with a ball and one with a corner.

constexpr ball<2> thrown{{0, 0}, {2, 1}, 1};
constexpr auto at_point = *time_of_impact(thrown, ball<2>{{5, 3}, {0, 0}, 0});
constexpr auto at_corner = *time_of_impact(thrown, wall<2>{{5, 3}, {{{{1, 4}}}}});
constexpr auto at_larger = *time_of_impact(thrown, ball<2>{{5, 3}, {0, 0}, 0x1p-60});
static_assert(at_point == at_corner && at_larger < at_point);
static_assert(solve(exact_ball<2>{{{0, 0}}, {{2, 1}}, 1}, wall<2, rational>{{{5, 3}}, {{{{1, 4}}}}}).where ==
              feature::corner);

// ---- Newton's cradle: five equal balls, of which the last four touch. One comes, one goes.

using cradle = std::array<ball<2>, 5>;

// Resolves the earliest collision of neighbours. No time passes between the collisions of balls that touch.
constexpr bool next_impact(cradle& balls) {
    std::size_t first = balls.size();
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
        const auto time = time_of_impact(balls[i], balls[i + 1]);
        if (time && (first == balls.size() || *time < *time_of_impact(balls[first], balls[first + 1]))) {
            first = i;
        }
    }
    if (first == balls.size()) {
        return false;
    }
    const auto s = solve(balls[first], balls[first + 1]);
    for (auto& b : balls) {
        b.position = position_at(b.position, b.velocity, s.time);
    }
    balls[first].velocity = s.velocity_a;
    balls[first + 1].velocity = s.velocity_b;
    return true;
}
constexpr bool cradle_swings(int moving) {
    cradle balls{};
    for (int i = 0; i < 5; ++i) {
        auto& b = balls[static_cast<std::size_t>(i)];
        b = {{2.0 * i - (i < moving ? 8 : 0), 0}, {i < moving ? 1.0 : 0.0, 0}, 1};
    }
    int impacts = 0;
    while (next_impact(balls)) {
        ++impacts;
    }
    for (int i = 0; i < 5; ++i) {
        const auto& b = balls[static_cast<std::size_t>(i)];
        if (b.velocity[0] != (i >= 5 - moving ? 1.0 : 0.0) || b.position[0] != 2.0 * i) {
            return false;
        }
    }
    return impacts == moving * (5 - moving);
}
static_assert(cradle_swings(1) && cradle_swings(2) && cradle_swings(3) && cradle_swings(4));

// ---- A pool rack: the cue ball meets the foremost one, which touches two others in the directions (4, ±3)/5.

constexpr ball<2> cue{{-30, 0}, {1, 0}, 5};
constexpr ball<2> front{{0, 0}, {0, 0}, 5};
constexpr ball<2> left{{8, 6}, {0, 0}, 5};
constexpr ball<2> right{{8, -6}, {0, 0}, 5};
static_assert(classify(front, left) == encounter::recede && classify(left, right) == encounter::recede, "at rest");
static_assert(*time_of_impact(cue, front) == 20.0 && *time_of_impact(cue, front) < *time_of_impact(cue, left));
static_assert(*time_of_impact(cue, left) == *time_of_impact(cue, right), "a tie by symmetry");
constexpr auto broken = solve(cue, front);
static_assert(broken.velocity_a == vec<2, double>{{0, 0}} && broken.velocity_b == vec<2, double>{{1, 0}});
constexpr ball<2> driven{front.position, broken.velocity_b, 5};
static_assert(classify(driven, left) == encounter::hit && *time_of_impact(driven, left) == 0.0 &&
              *time_of_impact(driven, left) == *time_of_impact(driven, right));
// Whichever of the two is resolved first leaves along the line of centres: in rationals, where (4, 3)/5 is a number.
constexpr auto to_left = solve(exact_ball<2>{{{0, 0}}, {{1, 0}}, 5}, exact_ball<2>{{{8, 6}}, {{0, 0}}, 5});
constexpr auto to_right = solve(exact_ball<2>{{{0, 0}}, {{1, 0}}, 5}, exact_ball<2>{{{8, -6}}, {{0, 0}}, 5});
static_assert(to_left.time == surd(0) && to_left.velocity_b[0] == surd(rational(16, 25)) &&
              to_left.velocity_b[1] == surd(rational(12, 25)) && to_left.velocity_a[1] == surd(rational(-12, 25)) &&
              to_right.velocity_b[1] == surd(rational(-12, 25)) && to_right.velocity_a[0] == to_left.velocity_a[0]);

} // namespace
