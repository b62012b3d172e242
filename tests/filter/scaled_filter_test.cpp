// The filter of any formula of a motion: its range, and that it answers `open` where it is not certain.
#include <graze/filter/scaled_filter.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/pair/computed_motion.hpp>

#include <doctest/doctest.h>

#include <limits>

namespace {

using limits = std::numeric_limits<double>;
using bounds = graze::detail::plane_bounds<3, double>;
using graze::detail::open;

auto motion(double height, double radius) {
    return graze::detail::computed_motion(graze::ball<3, double>{{1, 2, height}, {0, 0, -1}, radius},
                                          graze::plane<3, double>{{0, 0, 0}, {0, 0, 1}});
}
int clearance(double height, double radius) {
    return graze::detail::filtered_sign<bounds>(graze::plane_clearance{}, motion(height, radius),
                                                {3 + height + radius, 1, 1});
}

} // namespace

TEST_CASE("The sum of magnitudes") {
    CHECK(graze::detail::sum_of_magnitudes(graze::vec<3, double>{{1, -2, 4}}) == 7);
    CHECK(graze::detail::sum_of_magnitudes(graze::vec<2, double>{{-0.0, 0}}) == 0);
}

TEST_CASE("Scales out of range, or not numbers, are not usable") {
    CHECK(graze::detail::usable<double>({1, 1, 1}));
    CHECK(graze::detail::usable<double>({0x1p-49, 0x1p49, 1}));
    for (const double bad : {0.0, 0x1p50, 0x1p-51, limits::infinity(), limits::quiet_NaN(), limits::denorm_min()}) {
        CHECK(!graze::detail::usable<double>({bad, 1, 1}));
        CHECK(!graze::detail::usable<double>({1, bad, 1}));
        CHECK(!graze::detail::usable<double>({1, 1, bad}));
    }
    CHECK(graze::detail::usable<double>({0x1p-40, 1, 1}));
    CHECK(!graze::detail::usable<float>({0x1p-40, 1, 1})); // too near the subnormal floats
}

TEST_CASE("A sign is certain or open") {
    CHECK(clearance(5, 1) == 1);
    CHECK(clearance(0.5, 1) == -1);
    CHECK(clearance(1, 1) == open);
    CHECK(clearance(1 + 0x1p-52, 1) == open);
    CHECK(clearance(1 - 0x1p-53, 1) == open);
    CHECK(clearance(1 + 0x1p-40, 1) == 1);
    CHECK(clearance(1 - 0x1p-40, 1) == -1);
    CHECK(clearance(limits::quiet_NaN(), 1) == open);
}
