// The comparison's truth against the tests' own oracle, and its condition numbers against those worked out by hand.
#include "families.hpp"
#include "group.hpp"
#include "pairs.hpp"

#include "exact_doubles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

namespace truth_test {

using namespace compare;

namespace {

template <int N>
void check_family(const families::family& family) {
    INFO(std::string(family.name), " in ", N, " dimensions");
    for (std::uint64_t i = 0; i < 40; ++i) {
        const auto pair = family.draw<N>(7, i);
        const truth found = truth_of(to_problem<N>(pair, ""));
        const oracle::answer expected = test::meet(pair);
        CHECK(static_cast<int>(found.what) == static_cast<int>(expected.what));
        if (expected.time) {
            CHECK(found.time.nearest() == oracle::nearest_double(*expected.time));
        }
    }
}

// Meets the triangle that is the half, at the corner, of a family's wall.
oracle::answer meet_triangle(const families::pair_of_doubles<3>& pair) {
    return oracle::meet(pair.a, graze::triangle<double>{pair.wall.corner, pair.wall.edge});
}

exact_ball<2> ball(int x, int y, int u, int v, const exact& radius, const exact& mass = 1) {
    return {{{{exact(x), exact(y)}}, {{exact(u), exact(v)}}, radius, exact(1)}, exact(1) / mass};
}

} // namespace

TEST_CASE("decisions and times are the oracle's, in every family") {
    for (const families::family& family : families::all_families) {
        check_family<2>(family);
        check_family<3>(family);
    }
}

TEST_CASE("of triangles too, with the features that they have") {
    std::map<graze::feature, int> met;
    for (const families::family& family : families::all_families) {
        for (std::uint64_t i = 0; i < 90; ++i) {
            const auto pair = family.draw<3>(7, i);
            if (pair.kind != families::pair_kind::ball_wall) {
                continue;
            }
            problem<3> triangle = to_problem<3>(pair, "");
            triangle.kind = pair_kind::ball_triangle;
            const truth found = truth_of(triangle);
            const oracle::answer expected = meet_triangle(pair);
            CHECK(static_cast<int>(found.what) == static_cast<int>(expected.what));
            CHECK(static_cast<int>(encounter_of_pair<3>(triangle)) == static_cast<int>(expected.what));
            if (graze::is_collision(found.what)) {
                CHECK(expected.has(static_cast<oracle::feature>(found.where), found.index));
                CHECK(found.time.nearest() == oracle::nearest_double(*expected.time));
                ++met[found.where];
            }
        }
    }
    CHECK(met[graze::feature::face] > 10);
    CHECK(met[graze::feature::edge] > 10);
    CHECK(met[graze::feature::corner] > 10);
}

TEST_CASE("the borders of a triangle: its slanted edge") {
    // A point that falls onto the plane of the triangle (0,0) (4,0) (0,4), at (3,0.5): 0.5/√2 inside the slanted edge.
    problem<3> pair;
    pair.kind = pair_kind::ball_triangle;
    pair.a = {{{{exact(3), exact(exact(1) / 2), exact(2)}}, {{exact(0), exact(0), exact(-1)}}, exact(0), exact(1)},
              exact(1)};
    pair.wall = {{{exact(0), exact(0), exact(0)}},
                 {{{{exact(4), exact(0), exact(0)}}, {{exact(0), exact(4), exact(0)}}}}};
    const truth t = truth_of(pair);
    CHECK(t.what == graze::encounter::hit);
    const double length_square = 9 + 0.25 + 4 + 32;
    CHECK(t.borders.hitting == doctest::Approx(0.125 / length_square));
    pair.a.shape.position[1] = exact(2); // 1/√2 outside
    const truth beside = truth_of(pair);
    CHECK(beside.what == graze::encounter::miss);
    CHECK(beside.borders.hitting == doctest::Approx(0.5 / (9 + 4 + 4 + 32)));
}

TEST_CASE("a head-on collision") {
    problem<2> pair;
    pair.a = ball(0, 0, 2, 0, 1, 3);
    pair.b = ball(10, 0, -1, 0, 2, 1);
    const truth t = truth_of(pair);
    CHECK(t.what == graze::encounter::hit);
    CHECK(t.time.exactly() == exact_real(exact(exact(7) / 3)));
    CHECK(t.discriminant->exactly() == exact_real(81)); // h = -30, a = 9, c = 91
    CHECK(t.positions.size() == 4);
    CHECK(t.positions[0].exactly() == exact_real(exact(exact(14) / 3)));
    CHECK(t.positions[2].exactly() == exact_real(exact(exact(23) / 3)));
    CHECK(t.velocities[0].exactly() == exact_real(exact(exact(1) / 2))); // (3·2 - 1 + 1·(-1-2))/4
    CHECK(t.velocities[2].exactly() == exact_real(exact(exact(7) / 2)));
    CHECK(t.before.momentum);
    // τ = (10 - R)/3: Σ |x ∂τ/∂x| = (10 + 7/3·3 + 3)/3, over τ.
    CHECK(*t.time_condition == doctest::Approx((10 + 7 + 3) / 7.0));
    // D = R²·9 on a line through both centres: 2R²·9 from R, 2·R²·3·(2 + 1) from the velocities.
    CHECK(*t.discriminant_condition == doctest::Approx((2 * 81 + 2 * 9 * 3 * 3) / 81.0));
}

TEST_CASE("an infinite mass conserves nothing") {
    problem<2> pair;
    pair.a = ball(0, 0, 2, 0, 1);
    pair.b = ball(10, 0, -1, 0, 2);
    pair.b.inverse_mass = 0;
    const truth t = truth_of(pair);
    CHECK_FALSE(t.before.momentum);
    CHECK_FALSE(t.before.energy);
    CHECK(t.velocities[0].exactly() == exact_real(-4));
    CHECK(t.velocities[2].exactly() == exact_real(-1));
}

TEST_CASE("a graze has a time of infinite condition") {
    problem<2> pair;
    pair.a = ball(0, 3, 1, 0, 1);
    pair.b = ball(5, 0, 0, 0, 2);
    const truth t = truth_of(pair);
    CHECK(t.what == graze::encounter::graze);
    CHECK(t.time.nearest() == 5.0);
    CHECK(std::isinf(*t.time_condition));
    CHECK_FALSE(t.discriminant_condition);
}

TEST_CASE("walls: a face and a corner") {
    problem<2> pair;
    pair.kind = pair_kind::ball_wall;
    pair.wall = {{{exact(10), exact(-5)}}, {{{{exact(0), exact(10)}}}}};
    pair.a = ball(0, 0, 2, 0, 1);
    const truth face = truth_of(pair);
    CHECK(face.where == graze::feature::face);
    CHECK(face.time.exactly() == exact_real(exact(exact(9) / 2)));
    CHECK(face.velocities[0].exactly() == exact_real(-2));
    // (x + 2τ - 10)·n = -1·|n|, n = (-10, 0): x, p, u, n and r weigh 0, 10, 9, 0 and 1, over 9.
    CHECK(*face.time_condition == doctest::Approx((10 + 9 + 1) / 9.0));
    pair.a = ball(10, -20, 0, 2, 1);
    const truth corner = truth_of(pair);
    CHECK(corner.where == graze::feature::corner);
    CHECK(corner.index == 0);
    CHECK(corner.time.exactly() == exact_real(7));
    CHECK(*corner.time_condition == doctest::Approx((20 + 5 + 14 + 1) / 14.0));
}

TEST_CASE("any first part of a group holds every stratum in its share") {
    const auto g = make_group<2>({}, draw_family<2>("generic", 400, 3), progress_line(false));
    const auto& truths = std::get<group_pairs<2>>(g.pairs).truths;
    std::size_t hits = 0;
    for (std::size_t i = 0; i < 100; ++i) {
        hits += truths[i].what == graze::encounter::hit ? 1 : 0;
    }
    CHECK(g.information.pairs == 400);
    const auto share = static_cast<double>(g.information.encounters.at("hit")) / 4;
    CHECK(static_cast<double>(hits) == doctest::Approx(share).epsilon(0.05));
}

} // namespace truth_test
