// Exact values p + q√d: their nearest doubles, their distances from computed values, and their equality.
#include "answer_reader.hpp"
#include "reader.hpp"
#include "rounding.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace true_value_test {

using namespace compare;

namespace {

exact_real real(const exact& p, const exact& q = 0, const exact& d = 0) { return exact_real(p, q, d); }

true_value value_of(const exact_real& x) {
    root_memory roots;
    return true_value(x, roots);
}

const exact tiny = exact(1) / exact(exact_integer(1) << 2000U);

} // namespace

TEST_CASE("wide numbers hold doubles, and give them back") {
    for (const double x : {1.0, -0.1, 0x1.fffffffffffffp1023, 0x1p-1074, 0x1.8p-1060, -3e-310, 0.0}) {
        CHECK(nearest_double(wide(x)) == x);
        CHECK(static_cast<double>(to_exact(wide(x))) == x);
    }
    CHECK(nearest_double(ldexp(wide(1), 1024)) == std::numeric_limits<double>::infinity());
    CHECK(nearest_double(ldexp(wide(1), -1075)) == 0.0);       // a tie, to even
    CHECK(nearest_double(ldexp(wide(3), -1076)) == 0x1p-1074); // above it
    CHECK(nearest_double(wide(wide(1) + ldexp(wide(1), -53))) == 1.0);
    CHECK(nearest_double(wide(wide(1) + ldexp(wide(3), -54))) == 1.0 + 0x1p-52);
}

TEST_CASE("binary numbers are taken apart without an error") {
    const auto told = [](auto x) {
        computed_sink sink;
        sink.number(taken_apart(x));
        return std::get<wide>(sink.value().value());
    };
    CHECK(told(-0x1.23456789abcdfp+70) == wide(-0x1.23456789abcdfp+70));
    CHECK(told(0x1p-1074) == ldexp(wide(1), -1074));
    CHECK(told(0.0) == 0);
    CHECK(told(-0x1.fffffep+127F) == wide(-0x1.fffffep+127F));
    CHECK(told(1.0L + 0x1p-60L) == wide(wide(1) + ldexp(wide(1), -60)));
}

TEST_CASE("the nearest double of a root is the one that sqrt rounds to") {
    for (int d = 1; d < 200; ++d) {
        CHECK(value_of(real(0, 1, d)).nearest() == std::sqrt(static_cast<double>(d)));
        CHECK(value_of(real(0, -1, d)).nearest() == -std::sqrt(static_cast<double>(d)));
    }
}

TEST_CASE("where p and q√d cancel, no digit is lost") {
    // √(n² + 1) - n = 1/(√(n² + 1) + n), for n = 2^400.
    const exact n(exact_integer(1) << 400U);
    CHECK(value_of(real(-n, 1, n * n + 1)).nearest() == std::ldexp(1.0, -401));
    CHECK(value_of(real(n, -1, n * n + 1)).nearest() == -std::ldexp(1.0, -401));
}

TEST_CASE("ties and what lies next to them round as they must") {
    const exact middle = exact(1) + exact(1) / exact(exact_integer(1) << 53U); // between 1 and the next double
    CHECK(value_of(real(middle)).nearest() == 1.0);
    CHECK(value_of(real(middle + tiny)).nearest() == 1.0 + 0x1p-52);
    CHECK(value_of(real(middle - tiny)).nearest() == 1.0);
    // An irrational number, nearer to the middle than any enclosure: m ± 2^-2000 √2.
    CHECK(value_of(real(middle, tiny, 2)).nearest() == 1.0 + 0x1p-52);
    CHECK(value_of(real(middle, -tiny, 2)).nearest() == 1.0);
    CHECK(value_of(real(-middle, -tiny, 2)).nearest() == -1.0 - 0x1p-52);
}

TEST_CASE("equal numbers are equal in every form") {
    CHECK(equal(real(1, 2, 3), real(1, 1, 12)));
    CHECK(equal(real(1, 2, 9), real(7)));
    CHECK(equal(real(0, 1, exact(2) / 9), real(0, exact(1) / 3, 2)));
    CHECK_FALSE(equal(real(1, 2, 3), real(1, -2, 3)));
    CHECK_FALSE(equal(real(1, 2, 3), real(1, 2, 3 + tiny)));
    CHECK_FALSE(equal(real(1, 1, 2), real(2, 1, 2)));
}

TEST_CASE("distances") {
    const true_value third = value_of(real(exact(1) / 3));
    const true_value half = value_of(real(exact(1) / 2));
    const true_value root = value_of(real(0, 1, 2));
    CHECK(*distance(wide(0.5), half) == 0);
    CHECK(*distance(wide(0.75), half) == wide(0.25));
    CHECK(*distance(exact_real(exact(exact(1) / 3)), third) == 0);
    CHECK(*distance(real(0, 2, exact(1) / 2), root) == 0);
    CHECK(static_cast<double>(*distance(wide(0), root)) == std::sqrt(2.0));
    CHECK(*distance(root.value(), root) > 0); // as near as possible, but no rational number is √2
    CHECK(*distance(interval{wide(0.25), wide(1.5)}, half) == 1);
    CHECK_FALSE(distance(not_finite{}, half));
    CHECK(encloses(interval{wide(0.5), wide(0.5)}, half));
    CHECK(encloses(interval{wide(0.25), wide(0.5)}, half));
    CHECK_FALSE(encloses(interval{wide(0.5) + ldexp(wide(1), -800), wide(1)}, half));
    CHECK_FALSE(encloses(interval{wide(1), root.value() - ldexp(wide(1), -500)}, root));
    CHECK(rounds_correctly(wide(std::sqrt(2.0)), root));
    CHECK_FALSE(rounds_correctly(wide(std::nextafter(std::sqrt(2.0), 2.0)), root));
    CHECK(rounds_correctly(wide(wide(0.5) + ldexp(wide(1), -100)), half));
}

} // namespace true_value_test
