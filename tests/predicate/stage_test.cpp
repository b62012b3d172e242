// The answer and the stage that gave it: the filter decides easy cases, the next two stages hard ones, integers ties.
#include "answers.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <source_location>

namespace {

using enum graze::encounter;
using graze::stage;
using place = std::source_location;
using ball = graze::ball<3, double>;
using plane = graze::plane<3, double>;
using wall = graze::wall<3, double>;

template <class A, class B>
void expect(graze::encounter what, stage decided_by, const A& a, const B& b, const place here = place::current()) {
    CAPTURE(here.line());
    const auto answer = answers::of(a, b);
    CHECK(answer.what == what);
    CHECK(answer.decided_by == decided_by);
    CHECK(answers::is_right(answer, a, b));
}

template <class A, class B>
void expect_overlap(bool overlap, stage decided_by, const A& a, const B& b, const place here = place::current()) {
    CAPTURE(here.line());
    auto told = stage::filter;
    CHECK(answers::overlap_of(a, b, told) == overlap);
    CHECK(told == decided_by);
}

ball at(double x, double y, double z, double u, double v, double w, double radius = 1) {
    return {{{x, y, z}}, {{u, v, w}}, radius};
}

constexpr double up = 1 + 0x1p-52, down = 1 - 0x1p-53;

} // namespace

TEST_CASE("Two balls") {
    const ball rest = at(0, 0, 0, 0, 0, 0);
    expect(hit, stage::filter, at(5, 0.5, 0, -1, 0, 0), rest);
    expect(miss, stage::filter, at(5, 2.5, 0, -1, 0, 0), rest);
    expect(recede, stage::filter, at(5, 0.5, 0, 1, 0, 0), rest);
    expect(overlap, stage::filter, at(1, 0.5, 0, -1, 0, 0), rest);

    expect(graze::encounter::graze, stage::exact, at(5, 2, 0, -1, 0, 0), rest);
    expect(hit, stage::double_word, at(5, 2 * down, 0, -1, 0, 0), rest);
    expect(miss, stage::double_word, at(5, 2 * up, 0, -1, 0, 0), rest);
    expect(hit, stage::exact, at(2, 0, 0, -1, 0, 0), rest); // touching: c = 0
    expect(hit, stage::double_word, at(2 * up, 0, 0, -1, 0, 0), rest);
    expect(overlap, stage::double_word, at(2 * down, 0, 0, -1, 0, 0), rest);
    expect(recede, stage::exact, at(5, 0, 0, 0, 1, 0), rest); // h = 0
    expect(recede, stage::exact, at(0, 0, 0, 1, 1, 1), rest);
    expect(recede, stage::filter, rest, rest);
    expect(recede, stage::filter, at(1, 0, 0, 0.1, 0.2, 0.3), at(0x1p-600, 0, 0, 0.1, 0.2, 0.3, 0x1p600));
    expect(recede, stage::filter, at(2, 0, 0, 0, -0.0, 0), rest);
    expect(hit, stage::refined, at(5, 0, 0, -1, 0, 0, 0), at(0, 0, 0, 0, 0, 0, 0x1p-80)); // D is 2^-160
    expect(graze::encounter::graze, stage::exact, at(5, 0, 0, -1, 0, 0, 0),
           at(0, 0, 0, 0, 0, 0, 0)); // points that meet

    // Far away: the filter's bound is at least 2^-45 L²V², while Lagrange's form loses only L/R.
    expect(hit, stage::refined, at(0x1p30, 1, 0, -1, 0, 0), rest);
    expect(miss, stage::refined, at(0x1p30, 3, 0, -1, 0, 0), rest);
    expect(hit, stage::refined, at(0x1p38 / 3, 1, 0x1p38 / 3, -1, 0x1p-40, -1), rest);
    // Δx × Δu is 7/4, or 2, from products of 2^50, which doubles know to within 3.
    expect(hit, stage::double_word, at(0x1p50, 0x1p50 + 1.75, 0, -1, -1, 0, 0.5), at(0, 0, 0, 0, 0, 0, 0.875));
    expect(miss, stage::double_word, at(0x1p50, 0x1p50 + 2, 0, -1, -1, 0, 0.5), at(0, 0, 0, 0, 0, 0, 0.875));

    // Too large or too small for the filter. Scaled, they are as easy as before.
    expect(hit, stage::filter, at(5, 0.5, 0, -0x1p-300, 0, 0), rest);
    expect(miss, stage::filter, at(5 * 0x1p600, 2.5 * 0x1p600, 0, -1, 0, 0, 0x1p600), at(0, 0, 0, 0, 0, 0, 0x1p600));
    expect(hit, stage::filter, at(0x1p-1070, 0, 0, -1, 0, 0, 0x1p-1074), at(0, 0, 0, 0, 0, 0, 0x1p-1074));
    const double huge = std::numeric_limits<double>::max();
    // Differences that overflow are scaled before they are taken.
    expect(hit, stage::filter, at(huge, 0, 0, -huge, 0, 0, huge), at(-huge, 0, 0, huge, 0, 0, 1));
    // A length that overflows, of balls whose radii are scaled as they are.
    expect(hit, stage::refined, at(huge, 0, 0, -1, 0, 0, 0x1p700), at(-huge, 0, 0, 0, 0, 0, 0x1p700));
    // At the ends of what is scaled as it is, and beyond.
    for (const double unit : {0x1p-905, 0x1p-895, 0x1p735, 0x1p745}) {
        const ball still = at(0, 0, 0, 0, 0, 0, unit);
        expect(hit, stage::filter, at(5 * unit, 0.5 * unit, 0, -0x1p-895, 0, 0, unit), still);
        expect(miss, stage::filter, at(5 * unit, 2.5 * unit, 0, -0x1p1020, 0, 0, unit), still);
        expect(recede, stage::filter, at(5 * unit, 0.5 * unit, 0, 0x1p-905, 0, 0, unit), still);
        expect(overlap, stage::filter, at(unit, 0.5 * unit, 0, -0x1p1023, 0, 0, unit), still);
    }
    expect(hit, stage::double_word, at(5 * 0x1p-600, 2 * down * 0x1p-600, 0, -1, 0, 0, 0x1p-600),
           at(0, 0, 0, 0, 0, 0, 0x1p-600));
    expect(hit, stage::exact, at(0x1p600, 0, 0, -1, 0, 0), rest); // R² underflows next to L²
    expect(graze::encounter::graze, stage::exact, at(5 * 0x1p-600, 2 * 0x1p-600, 0, -1, 0, 0, 0x1p-600),
           at(0, 0, 0, 0, 0, 0, 0x1p-600));

    // r_a + r_b = 1 + 2^-60 is no double.
    expect(overlap, stage::double_word, at(1, 0, 0, -1, 0, 0), at(0, 0, 0, 0, 0, 0, 0x1p-60));
    expect(hit, stage::double_word, at(5, 1, 0, -1, 0, 0), at(0, 0, 0, 0, 0, 0, 0x1p-60));
}

TEST_CASE("Whether two balls overlap") {
    const ball rest = at(0, 0, 0, 0, 0, 0);
    expect_overlap(true, stage::filter, at(1, 0, 0, 9, 9, 9), rest);
    expect_overlap(false, stage::filter, at(3, 0, 0, -1, 0, 0), rest);
    expect_overlap(false, stage::exact, at(2, 0, 0, 1, 0, 0), rest);
    expect_overlap(true, stage::double_word, at(2 * down, 0, 0, 1, 0, 0), rest);
    expect_overlap(false, stage::double_word, at(2 * up, 0, 0, 1, 0, 0), rest);
    expect_overlap(true, stage::double_word, at(0x1p-600, 0, 0, 1, 0, 0, 0x1p-600), at(0, 0, 0, 0, 0, 0, 0x1p-650));
}

TEST_CASE("A ball and a plane") {
    const plane floor{{{7, 8, 0}}, {{0, 0, 3}}};
    expect(hit, stage::filter, at(0, 0, 5, 1, 1, -1), floor);
    expect(hit, stage::filter, at(0, 0, -5, 1, 1, 1), floor);
    expect(recede, stage::filter, at(0, 0, 5, 1, 1, 1), floor);
    expect(overlap, stage::filter, at(0, 0, 0.5, 1, 1, -1), floor);

    expect(hit, stage::double_word, at(0, 0, 1, 1, 1, -1), floor); // touching
    expect(overlap, stage::double_word, at(0, 0, down, 1, 1, -1), floor);
    expect(hit, stage::double_word, at(0, 0, up, 1, 1, -1), floor);
    expect(recede, stage::filter, at(0, 0, 0.5, 1, 1, 0), floor); // inside, parallel
    expect(recede, stage::filter, at(0, 0, 5, 1, 1, 0), floor);
    expect(recede, stage::double_word, at(0, 0, 5, 1, 1, -1), plane{{{7, 8, 0}}, {{1, 1, 2}}}); // terms cancel
    expect(recede, stage::double_word, at(0, 0, 0, 1, 1, 5), floor); // the centre on the plane
    expect(hit, stage::double_word, at(0, 0, 5, 1, 1, -1), plane{{{7, 8, 0}}, {{0, 0, 0x1p-600}}});

    const plane slanted{{{0, 0, 0}}, {{1, 2, 2}}}; // |n| = 3
    expect(hit, stage::double_word, at(1, 1, 0, -1, 0, 0), slanted);
    expect(overlap, stage::double_word, at(down, 1, 0, -1, 0, 0), slanted);
    const plane odd{{{7, 8, 0}}, {{0, 0, 0.1}}}; // ties whose products need more than two doubles
    expect(hit, stage::exact, at(0, 0, 1.1, 1, 1, -1, 1.1), odd);
    expect(overlap, stage::double_word, at(0, 0, 1.1 * down, 1, 1, -1, 1.1), odd);
    expect_overlap(true, stage::filter, at(0, 0, 0.5, 1, 1, 0), floor);
    expect_overlap(false, stage::double_word, at(0, 0, -1, 1, 1, 0), floor);
}

TEST_CASE("What is at rest recedes, without integers against planes and walls") {
    const plane floor{{{7, 8, 0}}, {{0, 0, 3}}};
    const wall square{{{0, 0, 0}}, {{{{4, 0, 0}}, {{0, 4, 0}}}}};
    for (const double zero : {0.0, -0.0}) {
        expect(recede, stage::filter, at(0, 0, 5, zero, 0, 0), floor);
        expect(recede, stage::filter, at(0, 0, 0.5, zero, 0, 0), floor);
        expect(recede, stage::filter, at(2, 1, 5, zero, 0, 0), square);
        expect(recede, stage::filter, at(2, 1, 0.5, 0, zero, 0), square);
        expect_overlap(true, stage::filter, at(2, 1, 0.5, zero, 0, 0), square);
        expect_overlap(false, stage::filter, at(2, 1, 5, zero, 0, 0), square);
    }
    expect(recede, stage::refined, at(2, 1, 5, 0x1p-1074, 0, 0x1p-1074), square);
    expect(hit, stage::refined, at(2, 1, 5, 0, 0, -0x1p-1074), square);
}

TEST_CASE("A speed towards a plane that is zero because numbers are needs no more digits") {
    const wall square{{{0, 0, 0}}, {{{{4, 0, 0}}, {{0, 4, 0}}}}};
    expect(recede, stage::refined, at(2, 1, 5, 1, 0.1, 0), square); // along the face, over it
    expect(recede, stage::refined, at(2, 1, 0.5, 1, 0.1, 0), square);
    expect(recede, stage::double_word, at(9, 1, 5, 0, 0.1, 0), square); // along an edge: differences of products vanish
    // This point rises beside the end of a segment, at a distance whose product with the edge underflows.
    const graze::ball<2> point{{{0, -0x1.4p-298}}, {{0x1.8p-398, 0x1p-30}}, 0};
    const graze::wall<2> segment{{{0, 0}}, {{{{-2, 0}}}}};
    CHECK(graze::classify(point, segment) == miss);
}

TEST_CASE("A ball and a wall") {
    const wall square{{{0, 0, 0}}, {{{{4, 0, 0}}, {{0, 4, 0}}}}};
    expect(hit, stage::filter, at(2, 1, 5, 0.1, 0.1, -1), square);       // the face
    expect(hit, stage::filter, at(4.5, 2.1, 5, 0.1, 0.1, -1), square);   // an edge
    expect(hit, stage::filter, at(4.5, 4.5, 5, 0.01, 0.01, -1), square); // a corner
    expect(miss, stage::filter, at(6, 2.1, 5, 0.1, 0.1, -1), square);
    expect(recede, stage::filter, at(2, 1, 5, 0.1, 0.1, 1), square);
    expect(overlap, stage::filter, at(2, 1, 0.5, 0.1, 0.1, -1), square);

    expect(graze::encounter::graze, stage::double_word, at(5, 2, 5, 0, 0, -1), square); // an edge
    expect(hit, stage::double_word, at(5 * down, 2, 5, 0, 0, -1), square);
    expect(miss, stage::double_word, at(5 * up, 2, 5, 0, 0, -1), square);
    expect(graze::encounter::graze, stage::double_word, at(9, 2, 1, -1, 0, 0), square); // along the face
    expect(hit, stage::double_word, at(4, 2, 5, 0, 0, -1), square);                     // where face and edge meet
    expect(hit, stage::double_word, at(4, 4, 5, 0, 0, -1), square);                     // where all meet
    expect(overlap, stage::double_word, at(2, 1, down, 0, 0, -1), square);
    expect(hit, stage::double_word, at(2, 1, 1, 0, 0, -1), square);
    expect(hit, stage::double_word, at(4, 4, 5, 0, 0, -1, 0), square); // a point on the corner
    expect(miss, stage::double_word, at(4 * up, 4, 5, 0, 0, -1, 0), square);
    expect(graze::encounter::graze, stage::double_word, at(9, 9, 0, -1, -1, 0, 0),
           square); // along the wall, at its corner
    const wall odd{{{0, 0, 0}}, {{{{0.7, 0, 0}}, {{0, 0.3, 0}}}}};
    expect(hit, stage::exact, at(0.4, 0.1, 1.1, 0.1, 0, -1, 1.1), odd);
    expect(graze::encounter::graze, stage::exact, at(9, 0.1, 1.1, -1, 0, 0, 1.1), odd);
    expect(miss, stage::double_word, at(9, 0.1, 1.1 * up, -1, 0, 0, 1.1), odd);
    expect_overlap(true, stage::filter, at(2, 1, 0.5, 1, 1, 1), square);
    expect_overlap(false, stage::double_word, at(5, 2, 0, 1, 1, 1), square);
    expect_overlap(true, stage::double_word, at(5 * down, 2, 0, 1, 1, 1), square);
}
