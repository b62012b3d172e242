// The errors of the source, at run time: its printed form gives a wrong answer, and the library's form the right one.
#include "../oracle/contact.hpp"

#include <graze/number/adapter/gmp.hpp>
#include <graze/number/floating.hpp>
#include <graze/solve.hpp>

#include <doctest/doctest.h>

using graze::encounter;
using number = graze::gmp_rational;

static number ratio(int p, int q) { return number(p) / number(q); }

TEST_CASE("(12) lacks parentheses: the printed test denies a collision") {
    const number zero(0);
    const graze::ball<2, number> a{{{number(10), ratio(11, 5)}}, {{number(-2), zero}}, number(3)};
    const graze::ball<2, number> b{{{zero, zero}}, {{zero, zero}}, zero};
    const auto m = graze::relative_motion_of(a, b);
    const auto h = dot(m.dx, m.du);
    CHECK(h * h < squared_norm(m.du) * squared_norm(m.dx) - m.R * m.R); // as printed: no collision
    CHECK(solve(a, b).what == encounter::hit);
    CHECK(solve<graze::variant::textbook, graze::root_form::printed>(a, b).what == encounter::hit);

    const graze::ball<2> c{{{10, 2.2}}, {{-2, 0}}, 3}, d{{{0, 0}}, {{0, 0}}, 0};
    CHECK(solve(c, d).what == encounter::hit);
    CHECK(oracle::meet(c, d).what == oracle::encounter::hit);
}

TEST_CASE("(12) is not enough: a real root is no collision of balls that part") {
    const graze::ball<2> a{{{5, 0}}, {{1, 0}}, 1}, b{{{0, 0}}, {{0, 0}}, 1};
    const auto m = graze::relative_motion_of(a, b);
    CHECK(graze::discriminant_halved{}(graze::quadratic_of(m)) > 0);
    CHECK(solve(a, b).what == encounter::recede);
}

TEST_CASE("(2), (20) and (21): the normal points from b to a, and α is negative for balls that approach") {
    const graze::ball<2> a{{{-3, 0}}, {{2, 0}}, 1, 1}, b{{{3, 0}}, {{-2, 0}}, 1, 1};
    const auto s = solve(a, b);
    REQUIRE(s.what == encounter::hit);
    CHECK(s.normal[0] == -1);
    CHECK(graze::impulse(graze::reduced_mass(1.0, 1.0), s.normal, graze::relative_motion_of(a, b).du) < 0);
    CHECK(s.velocity_a[0] == -2);
    CHECK(s.velocity_b[0] == 2);
}

TEST_CASE("(22) divides by α, which is zero for a graze: the velocities stay") {
    const graze::ball<2> a{{{-4, 2}}, {{1, 0}}, 1, 3}, b{{{0, 0}}, {{0, 0}}, 1, 5};
    const auto s = solve(a, b);
    REQUIRE(s.what == encounter::graze);
    CHECK(s.time == 4);
    CHECK(s.velocity_a == a.velocity);
    CHECK(s.velocity_b == b.velocity);
}

TEST_CASE("(29): at contact ⟨Δu,X̂⟩ = -√D/R") {
    const number zero(0);
    const graze::ball<2, number> a{{{number(10), ratio(11, 5)}}, {{number(-2), zero}}, number(3)};
    const graze::ball<2, number> b{{{zero, zero}}, {{zero, zero}}, zero};
    const auto s = solve(a, b);
    const auto along = s.normal[0] * graze::sqrt_extension<number>(number(-2));
    CHECK(along == -graze::root(s.discriminant) / graze::sqrt_extension<number>(number(3)));
}

TEST_CASE("(33) is when the centre arrives; the ball touches earlier, from either side and with any normal") {
    const graze::plane<2> floor{{{7, 0}}, {{0, 3}}}, turned{{{7, 0}}, {{0, -0.5}}};
    const graze::ball<2> above{{{0, 10}}, {{1, -2}}, 1}, below{{{0, -10}}, {{1, 2}}, 1};
    const auto m = graze::relative_motion_of(above, floor);
    CHECK(graze::centre_crossing_time{}(graze::plane_height{}(m), graze::plane_speed{}(m)) == 5);
    for (const auto& plane : {floor, turned}) {
        for (const auto& ball : {above, below}) {
            const auto s = solve(ball, plane);
            CHECK(s.what == encounter::hit);
            CHECK(s.time == 4.5);
            CHECK(s.point[1] == 0);
            CHECK(s.velocity == graze::vec<2, double>{{1, -ball.velocity[1]}});
        }
    }
    const graze::ball<2> along{{{0, 10}}, {{1, 0}}, 1};
    CHECK(solve(along, floor).what == encounter::recede); // u·n = 0
}

TEST_CASE("section 2.2 lacks the rectangle test and the wall's border") {
    const graze::wall<3> wall{{{0, 0, 0}}, {{{{4, 0, 0}}, {{0, 4, 0}}}}};
    const auto fall = [&](double x, double y) { return solve(graze::ball<3>{{{x, y, 10}}, {{0, 0, -1}}, 5}, wall); };
    const auto face = fall(2, 2);
    CHECK(face.where == graze::feature::face);
    CHECK(face.time == 5);
    const auto edge = fall(2, -3);
    CHECK(edge.where == graze::feature::edge);
    CHECK(edge.time == 6); // 3² + 4² = 5²
    const auto corner = fall(-3, 4 + 4);
    CHECK(corner.what == encounter::graze); // 3² + 4² = 5²
    CHECK(corner.where == graze::feature::corner);
    CHECK(corner.time == 10);
    CHECK(fall(-4, -4).what == encounter::miss);
}
