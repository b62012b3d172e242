// One run in many number types: Galperin's billiard has the same count in all types with enough digits.
#include <graze/number/adapter/boost.hpp>
#include <graze/number/floating.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>
#include <graze/scene/first_events.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

namespace {

using bin_float_50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class T>
std::uint64_t collisions(int mass_ratio) {
    const std::vector<graze::ball<2, T>> balls = {{{{T(1), T(0)}}, {{T(0), T(0)}}, T(1) / T(8), T(1)},
                                                  {{{T(2), T(0)}}, {{T(-1), T(0)}}, T(1) / T(8), T(mass_ratio)}};
    const std::vector<graze::plane<2, T>> wall = {{{{T(0), T(0)}}, {{T(1), T(0)}}}};
    graze::run<graze::plain_mechanics<2, T>> run(graze::scene<2, T>{balls, wall, {}});
    return run.advance({}).events;
}

} // namespace

TEST_CASE("a run in any number type") {
    CHECK(collisions<float>(100) == 31);
    CHECK(collisions<double>(10000) == 314);
    CHECK(collisions<long double>(10000) == 314);
    CHECK(collisions<bin_float_50>(100) == 31);
}

// Takes 100,000 shells.
TEST_CASE("where nothing meets for long in a period, the first events are not known") {
    const std::vector<graze::ball<2, float>> aside = {{{0, 0}, {3, 0}, 0.5F, 1}, {{2, 1.5F}, {2, 0}, 0.5F, 1}};
    CHECK_THROWS_WITH_AS((void)graze::first_events(graze::scene<2, float>{.balls = aside, .period = {5, 5}}),
                         "period: nothing has met for long, and whether anything ever will is not known",
                         std::runtime_error);
}
