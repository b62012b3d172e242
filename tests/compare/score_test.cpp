// Answers compared with the truth: which decision was wrong, and which values are compared.
#include "score.hpp"

#include "rounding.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace score_test {

using namespace compare;
using graze::encounter;

namespace {

// Two balls of mass 1 and radius 1 in the plane, 10 apart; one flies at speed 2 towards the other, which is at rest.
truth head_on() {
    problem<2> pair;
    pair.a = {{{{exact(0), exact(0)}}, {{exact(2), exact(0)}}, exact(1), exact(1)}, exact(1)};
    pair.b = {{{{exact(10), exact(0)}}, {{exact(0), exact(0)}}, exact(1), exact(1)}, exact(1)};
    return truth_of(pair);
}

// The right answer, exactly.
answer right_answer(const truth& t) {
    answer a;
    a.what = t.what;
    a.discriminant = t.discriminant->exactly();
    a.time = t.time.exactly();
    for (const true_value& x : t.positions) {
        a.positions.emplace_back(x.exactly());
    }
    for (const true_value& x : t.velocities) {
        a.velocities.emplace_back(x.exactly());
    }
    return a;
}

row scored(const answer& given, const truth& t) {
    row_score score;
    score.add(given, t, -1);
    row r;
    score.write_to(r);
    return r;
}

answer deciding(encounter what) {
    answer a;
    a.what = what;
    a.discriminant = wide(1);
    return a;
}

} // namespace

TEST_CASE("the right answer has no error") {
    const truth t = head_on();
    const row r = scored(right_answer(t), t);
    CHECK(r.decisions.evaluated == 1);
    CHECK(r.decisions.wrong() == 0);
    for (const quantity q : {quantity::discriminant, quantity::time, quantity::position, quantity::velocity}) {
        CHECK(r.error(q).count == 1);
        CHECK(r.error(q).exact == 1);
        CHECK(r.error(q).correctly_rounded == 1);
    }
    CHECK(r.error(quantity::crossing).count == 0);
    CHECK(r.momentum.zero == 1);
    CHECK(r.energy.zero == 1);
}

TEST_CASE("errors are those of the values") {
    const truth t = head_on(); // τ = 4, velocities 0 and 2 after
    answer a = right_answer(t);
    a.time = wide(std::nextafter(4.0, 5.0));
    a.velocities[0] = ldexp(wide(1), -52); // a should stand still; this is half a last place of 2
    const row r = scored(a, t);
    CHECK(r.error(quantity::time).largest == 1.0);
    CHECK(r.error(quantity::time).correctly_rounded == 0);
    CHECK(r.error(quantity::velocity).largest == 0.5);
    CHECK(r.error(quantity::velocity).correctly_rounded == 0);
    CHECK(r.error(quantity::position).exact == 1);
    CHECK(r.momentum.largest == 0x1p-53); // gained 2^-52 of 2
    CHECK(r.energy.largest == 0x1p-106);  // gained 2^-104 of 4
    REQUIRE(r.cells.size() == 1);
    CHECK(r.cells[0].time_largest == 1.0);
}

TEST_CASE("a wrong decision is counted once, and its values are not") {
    const truth t = head_on();
    CHECK(scored(deciding(encounter::recede), t).decisions.approaching == 1);
    CHECK(scored(deciding(encounter::overlap), t).decisions.overlap == 1);
    CHECK(scored(deciding(encounter::miss), t).decisions.hit_or_miss == 1);
    CHECK(scored(deciding(encounter::graze), t).decisions.hit_or_miss == 1);
    const row r = scored(deciding(encounter::miss), t);
    CHECK(r.decisions.wrong() == 1);
    CHECK(r.error(quantity::time).count == 0);
    CHECK(r.error(quantity::discriminant).count == 1); // D counts whatever was decided from it
    CHECK(r.cells[0].wrong == 1);
}

TEST_CASE("no answer, and none yet") {
    const truth t = head_on();
    answer a;
    a.how = outcome::undecided;
    CHECK(scored(a, t).decisions.undecided == 1);
    CHECK(scored(a, t).decisions.wrong() == 0);
    a.how = outcome::failed;
    CHECK(scored(a, t).decisions.failed == 1);
    CHECK(scored(a, t).decisions.wrong() == 1);
}

TEST_CASE("intervals: the farther end, the width, and whether it holds the truth") {
    const truth t = head_on();
    answer a = right_answer(t);
    a.time = interval{wide(4), wide(4.5)};
    row r = scored(a, t);
    CHECK(r.error(quantity::time).largest == std::ldexp(0.5, 50));
    CHECK(r.width.largest == std::ldexp(0.5, 50));
    CHECK(r.not_enclosed == 0);
    a.time = interval{wide(4.25), wide(4.5)};
    r = scored(a, t);
    CHECK(r.not_enclosed == 1);
}

TEST_CASE("what is not a number is an infinite error") {
    const truth t = head_on();
    answer a = right_answer(t);
    a.time = not_finite{};
    const row r = scored(a, t);
    CHECK(r.error(quantity::time).not_finite == 1);
    CHECK(std::isinf(r.error(quantity::time).largest));
}

TEST_CASE("the distance from each border, where geometry tells it") {
    // Head-on, R = 2, 10 apart: f = |Δx|² - R² = 96, L² = 104, |Δu| = 2, h = -20. The centres meet, so the least f is
    // -4.
    border_distances d = head_on().borders;
    CHECK(d.receding == doctest::Approx(20 / (std::sqrt(104.0) * 2)));
    CHECK(d.overlapping == doctest::Approx(96.0 / 104));
    CHECK(d.hitting == doctest::Approx(4.0 / 104));
    CHECK(nearest_border(encounter::hit, d) == d.hitting);
    CHECK(nearest_border(encounter::overlap, d) == doctest::Approx(96.0 / 104));
    CHECK(nearest_border(encounter::recede, d) == d.receding);
    // A graze is on its border. A pair that misses by 2^-40 of R is about 2 R² 2^-40/L² away from it.
    problem<2> pair;
    pair.a = {{{{exact(0), exact(2)}}, {{exact(2), exact(0)}}, exact(1), exact(1)}, exact(1)};
    pair.b = {{{{exact(10), exact(0)}}, {{exact(0), exact(0)}}, exact(1), exact(1)}, exact(1)};
    CHECK(border_distances_of(pair).hitting == 0);
    pair.a.shape.position[1] += exact(2) / exact(exact_integer(1) << 40U);
    CHECK(border_distances_of(pair).hitting == doctest::Approx(8 * std::exp2(-40) / 108));
    // A point flies straight through a segment of length 8, 1 from its end; it starts at height 3, so L² = 9 + 1 + 64.
    pair.kind = pair_kind::ball_wall;
    pair.a = {{{{exact(1), exact(3)}}, {{exact(0), exact(-1)}}, exact(0), exact(1)}, exact(1)};
    pair.wall = {{{exact(0), exact(0)}}, {{{{exact(8), exact(0)}}}}};
    d = border_distances_of(pair);
    CHECK(d.hitting == doctest::Approx(1.0 / 74));
    CHECK(d.overlapping == doctest::Approx(9.0 / 74));
    CHECK(d.receding == doctest::Approx(3 / std::sqrt(74.0)));
    // It passes the end at a distance of 2: the least f is 4.
    pair.a.shape.position[0] = -2;
    CHECK(border_distances_of(pair).hitting == doctest::Approx(4.0 / 77));
    // In space: over the middle of a square of side 2, whose rim is 1 away, and beside its corner by (3, 4).
    problem<3> space;
    space.kind = pair_kind::ball_wall;
    space.a = {{{{exact(1), exact(1), exact(5)}}, {{exact(0), exact(0), exact(-1)}}, exact(0), exact(1)}, exact(1)};
    space.wall = {{{exact(0), exact(0), exact(0)}},
                  {{{{exact(2), exact(0), exact(0)}}, {{exact(0), exact(2), exact(0)}}}}};
    CHECK(border_distances_of(space).hitting == doctest::Approx(1.0 / (27 + 8)));
    space.a.shape.position = {{exact(-3), exact(-4), exact(5)}};
    CHECK(border_distances_of(space).hitting == doctest::Approx(25.0 / (50 + 8)));
}

TEST_CASE("the wrong and the worst pairs are kept, by number, with what was said") {
    const truth t = head_on();
    truth near = t, far = t;
    near.borders.hitting = 1e-9, far.borders.hitting = 0.5;
    row_score score;
    score.add(deciding(encounter::miss), t, -1, 4);
    score.add(deciding(encounter::miss), near, -1, 5);
    score.add(deciding(encounter::miss), far, -1, 6);
    answer off = right_answer(t), worse = off;
    off.time = wide(4.5);
    worse.time = not_finite{};
    score.add(off, t, -1, 7);
    score.add(right_answer(t), t, -1, 8);
    row r;
    score.write_to(r);
    const auto find = [&](const std::string& what, const std::string& which) {
        const auto at = std::find_if(r.extremes.begin(), r.extremes.end(),
                                     [&](const extreme_pair& e) { return e.what == what && e.which == which; });
        REQUIRE(at != r.extremes.end());
        return *at;
    };
    CHECK(find("hit_or_miss", "nearest").pair == 5);
    CHECK(find("hit_or_miss", "farthest").pair == 6);
    CHECK(find("hit_or_miss", "farthest").said == "miss");
    CHECK(find("hit_or_miss", "farthest").right == "hit");
    CHECK(find("time", "largest").pair == 7);
    CHECK(find("time", "largest").said == "4.5");
    CHECK(find("time", "largest").right == "4");
    CHECK(r.dots.size() == 5);
    CHECK(r.dots[0] == dot_wrong);
    CHECK(r.dots[4] == 0);
    score.add(worse, t, -1, 9);
    score.write_to(r = {});
    CHECK(find("time", "largest").pair == 9);
    CHECK(find("time", "largest").said == "no finite number");
}

} // namespace score_test
