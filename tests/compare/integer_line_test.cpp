// Flights in integers, compared with the same collisions in GMP's rationals, computed by the impulse at the contact.
#include "../property.hpp"
#include "run/integer_line.hpp"

#include <doctest/doctest.h>

namespace integer_line_test {

using compare::run::bounce_head_on;
using compare::run::bounce_off;
using compare::run::integer_line;

namespace {

mpq_class fraction(int numerator, int denominator) {
    mpq_class x(numerator, denominator);
    x.canonicalize();
    return x;
}
mpq_class ratio(const mpz_class& x, const mpz_class& y) {
    mpq_class q(x, y);
    q.canonicalize();
    return q;
}
int drawn(int low, int high) { return property::in_range(low, high); }

// A ball on the line y = 2/3 in rationals, and as a line of integers over a denominator that is not in lowest terms.
struct ball {
    mpq_class x, u;
    [[nodiscard]] integer_line<2> line(int times) const {
        const mpz_class d = x.get_den() * u.get_den() * 3 * times;
        return {d, {{x.get_num() * (d / x.get_den()), 2 * d / 3}}, {{u.get_num() * (d / u.get_den()), 0}}, {0, 1}};
    }
};
mpq_class place_at(const integer_line<2>& a, const mpq_class& t) {
    return ratio(a.place[0], a.denominator) + ratio(a.speed[0], a.denominator) * t;
}

} // namespace

TEST_CASE("head on, once and again") {
    CHECK(property::check([] {
        const mpq_class m = fraction(drawn(1, 50), drawn(1, 9)), n = fraction(drawn(1, 50), drawn(1, 9));
        const mpq_class reach = fraction(drawn(0, 9), drawn(1, 9));
        const ball a{fraction(drawn(-50, 0), drawn(1, 9)), fraction(drawn(1, 50), drawn(1, 9))};
        const ball b{a.x + reach + fraction(drawn(0, 50), drawn(1, 9)), a.u - fraction(drawn(1, 50), drawn(1, 9))};
        integer_line<2> x = a.line(drawn(1, 5)), y = b.line(drawn(1, 5));
        const bool first_is_behind = drawn(0, 2) == 0;
        const bool met = first_is_behind ? bounce_head_on<2>(x, y, reach, 1 / m, 1 / n)
                                         : bounce_head_on<2>(y, x, reach, 1 / n, 1 / m);
        PROPERTY_ASSERT(met);
        const mpq_class t = (b.x - a.x - reach) / (a.u - b.u);
        const mpq_class u = (m * a.u + n * b.u - n * (a.u - b.u)) / (m + n), v = u + a.u - b.u;
        PROPERTY_ASSERT(ratio(x.since.numerator, x.since.denominator) == t);
        PROPERTY_ASSERT(ratio(y.since.numerator, y.since.denominator) == t);
        PROPERTY_ASSERT(place_at(x, t) == a.x + a.u * t);
        PROPERTY_ASSERT(place_at(y, t) == b.x + b.u * t);
        PROPERTY_ASSERT(ratio(x.speed[0], x.denominator) == u);
        PROPERTY_ASSERT(ratio(y.speed[0], y.denominator) == v);
        PROPERTY_ASSERT(ratio(x.place[1], x.denominator) == fraction(2, 3));

        // Then the ball in front bounces off a plane across its way.
        const mpq_class r = fraction(drawn(0, 9), drawn(1, 9)), ahead = fraction(drawn(1, 50), drawn(1, 9));
        PROPERTY_PRE(sgn(v) > 0);
        const mpq_class wall = place_at(y, t) + r + ahead;
        PROPERTY_ASSERT(bounce_off<2>(y, r, {{wall, 7}}, {{fraction(drawn(1, 9), 4), 0}}));
        const mpq_class then = t + ahead / v;
        PROPERTY_ASSERT(ratio(y.since.numerator, y.since.denominator) == then);
        PROPERTY_ASSERT(place_at(y, then) == wall - r);
        PROPERTY_ASSERT(ratio(y.speed[0], y.denominator) == -v);
    }));
}

TEST_CASE("a mirror keeps its line, and what is not head on is left alone") {
    const ball still{9, 0}, coming{0, 2};
    integer_line<2> a = coming.line(1), mirror = still.line(2);
    REQUIRE(bounce_head_on<2>(a, mirror, 3, 1, 0));
    CHECK(place_at(mirror, 100) == 9);
    CHECK(place_at(a, 3) == 6);
    CHECK(place_at(a, 4) == 4);

    integer_line<2> b = coming.line(1), aside = still.line(1);
    aside.place[1] += 1;
    const mpz_class before = b.place[0];
    CHECK(!bounce_head_on<2>(b, aside, 3, 1, 1));
    CHECK(b.place[0] == before);
    CHECK(!bounce_off<2>(b, 1, {{9, 0}}, {{1, 1}}));
    CHECK(!bounce_off<2>(b, 1, {{9, 0}}, {{0, 1}})); // along the plane
}

} // namespace integer_line_test
