// From a computed value to a certain sign.
#include <graze/filter/static_filter.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {

using limits = std::numeric_limits<double>;
using graze::detail::certain_sign;
using graze::detail::open;
using graze::detail::within_powers;

struct square_of_a_difference {
    template <class T>
    constexpr auto operator()(const T& x) const {
        return x * x - x * x;
    }
};
constexpr graze::error_bound input = graze::error_bound::exact_input({0, 1, 2});

// Two products of magnitude 1 with an error of u each, and their difference: 4u, and the slack.
constexpr double k = graze::filter_constant(square_of_a_difference{}, input);
static_assert(k > 4 * 0x1p-52 && k < 4 * 0x1p-52 * (1 + 0x1p-39));
static_assert(graze::filter_degrees(square_of_a_difference{}, input) == graze::error_bound::degrees{0, 2, 4});

} // namespace

TEST_CASE("A value beyond its bound has a certain sign, all else is open") {
    CHECK(certain_sign(2.0, 1.0) == 1);
    CHECK(certain_sign(-2.0, 1.0) == -1);
    CHECK(certain_sign(1.0, 1.0) == open);
    CHECK(certain_sign(-1.0, 1.0) == open);
    CHECK(certain_sign(0.5, 1.0) == open);
    CHECK(certain_sign(0.0, 0.0) == open); // it has underflowed and is not decided
    CHECK(certain_sign(limits::quiet_NaN(), 1.0) == open);
    CHECK(certain_sign(1.0, limits::quiet_NaN()) == open);
    CHECK(certain_sign(limits::infinity(), limits::infinity()) == open);
    CHECK(certain_sign(limits::denorm_min(), 0.0) == 1);
}

TEST_CASE("Powers of a scale") {
    CHECK(graze::detail::power_of<0>(3.0) == 1.0);
    CHECK(graze::detail::power_of<1>(3.0) == 3.0);
    CHECK(graze::detail::power_of<2>(3.0) == 9.0);
    CHECK(graze::detail::power_of<5>(3.0) == 243.0);
    CHECK(graze::detail::power_of<12>(2.0) == 4096.0);
}

TEST_CASE("A range of powers of two holds its lower end and nothing that is not a positive number") {
    CHECK(within_powers<-50, 50>(0x1p-50));
    CHECK(within_powers<-50, 50>(1.0));
    CHECK(within_powers<-50, 50>(std::nextafter(0x1p50, 0.0)));
    CHECK(!within_powers<-50, 50>(0x1p50));
    CHECK(!within_powers<-50, 50>(std::nextafter(0x1p-50, 0.0)));
    for (const double x : {0.0, -0.0, -1.0, limits::denorm_min(), limits::infinity(), -limits::infinity(),
                           limits::quiet_NaN(), -limits::quiet_NaN(), limits::max(), limits::lowest()}) {
        CHECK(!within_powers<-50, 50>(x));
    }
}
