// Errors and their summaries, against values worked out by hand.
#include "statistics.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace statistics_test {

using namespace compare;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

wide power(long exponent) { return ldexp(wide(1), exponent); }

} // namespace

TEST_CASE("a quantile is one of the values") {
    const std::vector<double> sorted = {1, 2, 3, 4};
    CHECK(quantile(sorted, 0.0) == 1);
    CHECK(quantile(sorted, 0.25) == 1);
    CHECK(quantile(sorted, 0.26) == 2);
    CHECK(quantile(sorted, 0.5) == 2);
    CHECK(quantile(sorted, 0.75) == 3);
    CHECK(quantile(sorted, 1.0) == 4);
    std::vector<double> mixed = {5, 1, 3};
    CHECK(median(mixed) == 3);
}

TEST_CASE("an error is counted in the exact value's last place") {
    error_sample sample;
    CHECK(sample.add(power(-52), wide(1), true) == 1.0);    // the last place of 1 is 2^-52
    CHECK(sample.add(power(-52), wide(1.75), true) == 1.0); // the same for all of [1, 2)
    CHECK(sample.add(power(-52), wide(2), true) == 0.5);    // and twice as much from 2 on
    CHECK(sample.add(power(-54), wide(0.75), true) == 0.5); // half as large below 1
    CHECK(sample.add(wide(0), wide(3), true) == 0.0);
    CHECK(sample.add(power(-2000), power(-1900), true) == 0x1p-48); // the range of double does not matter
    const error_statistics s = sample.summary();
    CHECK(s.count == 6);
    CHECK(s.exact == 1);
    CHECK(s.correctly_rounded == 6);
    CHECK(s.largest == 1.0);
    CHECK(s.median == 0.5);
    CHECK(s.histogram == std::map<int, std::size_t>{{-48, 1}, {-1, 2}, {0, 2}});
    CHECK(s.fewest_bits == doctest::Approx(52.0)); // the first one: 2^-52 of 1
    CHECK(s.quantiles.front() == 0.0);
    CHECK(s.quantiles.back() == 1.0);
}

TEST_CASE("what has no last place or no value is counted, not averaged") {
    error_sample sample;
    CHECK_FALSE(sample.add(power(-60), wide(0), false));
    CHECK(sample.add(wide(0), wide(0), true) == 0.0);
    sample.add_not_finite();
    const error_statistics s = sample.summary();
    CHECK(s.unscaled == 1);
    CHECK(s.not_finite == 1);
    CHECK(s.count == 2);
    CHECK(s.exact == 1);
    CHECK(s.largest == infinity);
    CHECK(s.fewest_bits == -infinity);
    CHECK(s.histogram.empty());
}

TEST_CASE("nothing measured is nothing told") {
    CHECK(error_sample().summary().count == 0);
    CHECK(defect_sample().summary().count == 0);
}

TEST_CASE("defects") {
    defect_sample sample;
    for (const double x : {0.25, 0.0, 0.5}) {
        sample.add(x);
    }
    const defect_statistics s = sample.summary();
    CHECK(s.count == 3);
    CHECK(s.zero == 1);
    CHECK(s.median == 0.25);
    CHECK(s.largest == 0.5);
}

} // namespace statistics_test
