// graze::solve for a ball and a wall in a number type that has a square root of its own and may round: the sign of
// p ± q√d, and the normal and velocity of a graze and of a point. (For exact types see predicate/scenes.cpp and
// wall_scenes.cpp.)
#include <graze/number/floating.hpp>
#include <graze/solve.hpp>

#include "../rational.hpp"

namespace {

using namespace graze;
using proof::rational;
using surd = sqrt_extension<rational>;

// A discriminant that only a rounding makes negative has the root 0.
static_assert([] {
    const flat_motion<2, double> m{{{0, 1}}, {{1, 0}}, {{{{0, 1}}}}, 1, false};
    const detail::direct_judge<2, double> judge(m);
    double root = 5;
    return judge.root(9, root) && root == 3 && judge.root(-1, root) && root == 0;
}());

// Cases where the answer depends on that sign: in doubles, and by either root of d.
constexpr wall<3> square{{5, -3, -3}, {{{{0, 6, 0}}, {{0, 0, 6}}}}};
constexpr bool meets(double x, double y, double z, double v, double w, feature where, int index) {
    const auto s = solve(ball<3>{{x, y, z}, {x < 5 ? 1.0 : -1.0, v, w}, 1}, square);
    return s.what == encounter::hit && s.where == where && s.index == index;
}
constexpr bool meets_from_both_sides(double y, double z, double v, double w, feature where, int index) {
    return meets(0, y, z, v, w, where, index) && meets(10, y, z, v, w, where, index);
}
// At 45° a ball of radius 1 touches the plane where its centre is at x = 4 and has gone 4 along the face, which ends
// at ±3: beyond that it meets an edge, beyond both ends a corner.
static_assert(meets_from_both_sides(-1.5, 0, 1, 0, feature::face, 0) &&
              meets_from_both_sides(-0.8, 0, 1, 0, feature::edge, 1) &&
              meets_from_both_sides(1.5, 0, -1, 0, feature::face, 0) &&
              meets_from_both_sides(0.8, 0, -1, 0, feature::edge, 0));
static_assert(meets_from_both_sides(0, -1.5, 0, 1, feature::face, 0) &&
              meets_from_both_sides(0, -0.8, 0, 1, feature::edge, 3) &&
              meets_from_both_sides(0, 0.8, 0, -1, feature::edge, 2) &&
              meets_from_both_sides(-0.9, -0.9, 1, 1, feature::corner, 3) &&
              meets_from_both_sides(0.9, 0.9, -1, -1, feature::corner, 0));

// A graze changes no velocity, also where the normal (3, -4)/5 is rounded.
constexpr ball<2> passing{{-1, -7}, {4, 3}, 5};
constexpr auto touch = solve(passing, wall<2>{{0, 0}, {{{{0, 6}}}}});
static_assert(touch.what == encounter::graze && touch.where == feature::corner && touch.time == 1);
static_assert(touch.velocity == passing.velocity && reflected(passing.velocity, touch.normal) != passing.velocity);

// A point that flies within the plane touches the end of the wall: there is no normal, and the velocity stays.
constexpr auto point_at_end =
    solve(ball<2, rational>{{{0, 5}}, {{0, -1}}, 0}, wall<2, rational>{{{0, -2}}, {{{{0, 4}}}}});
static_assert(point_at_end.what == encounter::graze && point_at_end.where == feature::corner &&
              point_at_end.time == surd(3) && point_at_end.point == point_at_end.position);
static_assert(point_at_end.normal == detail::zero_vector<2, surd>() && point_at_end.velocity[1] == surd(-1));
constexpr auto point_at_edge = solve(ball<3, rational>{{{0, 5, 0}}, {{0, -1, 0}}, 0},
                                     wall<3, rational>{{{0, -2, -3}}, {{{{0, 4, 0}}, {{0, 0, 6}}}}});
static_assert(point_at_edge.what == encounter::graze && point_at_edge.where == feature::edge &&
              point_at_edge.index == 1 && point_at_edge.normal == detail::zero_vector<3, surd>());

// A ball that slides over the face, or along an edge, at exactly the distance r keeps that distance for a while. It
// touches the wall where it arrives, not where it leaves; at a corner it arrives along both edges.
constexpr wall<3, rational> flat{{{0, -2, -3}}, {{{{0, 4, 0}}, {{0, 0, 6}}}}};
constexpr bool grazes(const ball<3, rational>& b, int time, feature where, int index) {
    const auto s = solve(b, flat);
    return s.what == encounter::graze && s.time == surd(time) && s.where == where && s.index == index;
}
constexpr bool slides_from(const vec<3, rational>& x, const vec<3, rational>& u, int time, feature where, int index) {
    return grazes({x, u, 1}, time, where, index);
}
static_assert(slides_from({{1, -5, 1}}, {{0, 1, 0}}, 3, feature::edge, 0) &&
              slides_from({{-1, 5, 1}}, {{0, -1, 0}}, 3, feature::edge, 1) &&
              slides_from({{1, 1, -5}}, {{0, 0, 1}}, 2, feature::edge, 2) &&
              slides_from({{-1, 1, 5}}, {{0, 0, -1}}, 2, feature::edge, 3));
static_assert(slides_from({{0, 3, -5}}, {{0, 0, 1}}, 2, feature::corner, 1) &&
              slides_from({{0, 3, 5}}, {{0, 0, -1}}, 2, feature::corner, 3) &&
              slides_from({{0, -5, -4}}, {{0, 1, 0}}, 3, feature::corner, 0) &&
              slides_from({{0, 5, 4}}, {{0, -1, 0}}, 3, feature::corner, 3));
constexpr bool grazes(const ball<2, rational>& b, int time, int index) {
    const auto s = solve(b, wall<2, rational>{{{0, -2}}, {{{{0, 4}}}}});
    return s.what == encounter::graze && s.time == surd(time) && s.where == feature::corner && s.index == index;
}
static_assert(grazes({{{1, -5}}, {{0, 1}}, 1}, 3, 0) && grazes({{{1, 5}}, {{0, -1}}, 1}, 3, 1));

// A ball that leaves the wall and comes down to its plane, or goes up from it, touches the rim from above: at (4, 3)/5
// from an edge or an end, at (1, 2, 2)/3 from a corner.
static_assert(grazes({{{7, 1, 1}}, {{-3, 4, 0}}, 5}, 1, feature::edge, 1) &&
              grazes({{{-7, -1, 1}}, {{3, -4, 0}}, 5}, 1, feature::edge, 0) &&
              grazes({{{7, 1, -2}}, {{-3, 0, -4}}, 5}, 1, feature::edge, 2));
static_assert(grazes({{{7, 1}}, {{-3, 4}}, 5}, 1, 1) && grazes({{{-7, -1}}, {{3, -4}}, 5}, 1, 0));
static_assert(grazes({{{5, 3, 4}}, {{-4, 1, 1}}, 3}, 1, feature::corner, 3) &&
              grazes({{{-5, -3, -4}}, {{4, -1, -1}}, 3}, 1, feature::corner, 0));

// A ball that touches the rim at t = 0 and approaches hits it at t = 0. A large ball meets the nearer end, not the end
// that it would meet if the wall ended only there.
constexpr bool hits(const ball<3, rational>& b, int time, feature where, int index) {
    const auto s = solve(b, flat);
    return s.what == encounter::hit && s.time == surd(time) && s.where == where && s.index == index;
}
constexpr bool hits(const ball<2, rational>& b, int time, int index) {
    const auto s = solve(b, wall<2, rational>{{{0, -2}}, {{{{0, 4}}}}});
    return s.what == encounter::hit && s.time == surd(time) && s.where == feature::corner && s.index == index;
}
static_assert(hits({{{0, 3, 0}}, {{0, -1, 0}}, 1}, 0, feature::edge, 1) &&
              hits({{{1, 4, 5}}, {{-1, 0, 0}}, 3}, 0, feature::corner, 3) && hits({{{0, 3}}, {{0, -1}}, 1}, 0, 1));
static_assert(hits({{{3, 10}}, {{0, -1}}, 5}, 4, 1) && hits({{{3, -10}}, {{0, 1}}, 5}, 4, 0));
static_assert(hits({{{1, 9, 5}}, {{0, -1, 0}}, 3}, 5, feature::corner, 3) &&
              hits({{{1, 4, 10}}, {{0, 0, -1}}, 3}, 5, feature::corner, 3) &&
              hits({{{1, -9, -5}}, {{0, 1, 0}}, 3}, 5, feature::corner, 0));

} // namespace
