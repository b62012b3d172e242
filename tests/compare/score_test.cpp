// Answers compared with the truth: which decision was wrong, and which values are compared.
#include "score.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace compare;
using graze::encounter;

namespace {

// Two balls of mass 1 and radius 1 in the plane, 10 apart, one at speed 2 towards the other, at rest.
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
    a.velocities[0] = ldexp(wide(1), -52); // a should stand still: half a last place of 2
    const row r = scored(a, t);
    CHECK(r.error(quantity::time).largest == 1.0);
    CHECK(r.error(quantity::time).correctly_rounded == 0);
    CHECK(r.error(quantity::velocity).largest == 0.5);
    CHECK(r.error(quantity::velocity).correctly_rounded == 0);
    CHECK(r.error(quantity::position).exact == 1);
    CHECK(r.momentum.largest == 0x1p-53); // 2^-52 gained of 2
    CHECK(r.energy.largest == 0x1p-106);  // 2^-104 gained of 4
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
    CHECK(r.error(quantity::discriminant).count == 1); // D is there whatever it led to
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
