// A batch's times are those of the scalar functions, in every rounding mode. For some pairs the oracle is asked, too.
#include "../oracle/encounter.hpp"
#include "../predicate/batch_pairs.hpp"

#include <graze/classify.hpp>
#include <graze/time_of_impact.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using graze::rounding;

// Compares bits, so +0 and -0 differ.
template <class T>
bool same_bits(const std::vector<T>& x, const std::vector<T>& y) {
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::bit_cast<bits>(x[i]) != std::bit_cast<bits>(y[i])) {
            return false;
        }
    }
    return x.size() == y.size();
}

// In the widest registers of graze::compiled, and in those of this unit alone, as without graze::compiled.
template <class A, class B, class T>
std::vector<T> times_of(const A& a, const B& b, rounding mode, std::vector<T> time) {
    std::vector<T> alone = time;
    graze::batch::time_of_impact(a, b, time, mode);
    graze::detail::time_all<graze::detail::unit_mode, 0>(graze::detail::source_of(a), graze::detail::source_of(b),
                                                         std::span(alone), mode);
    CHECK(same_bits(time, alone));
    return time;
}

template <int N, class T, class B>
T scalar_time(const graze::ball<N, T>& a, const B& b, rounding mode) {
    const auto time = graze::time_of_impact(a, b);
    return !time                        ? std::numeric_limits<T>::infinity()
           : mode == rounding::nearest  ? static_cast<T>(*time)
           : mode == rounding::downward ? time->lower()
                                        : time->upper();
}

template <int N, class T>
void check(const batches::pairs<N, T>& p) {
    const auto& a = p.a.all();
    const auto& b = p.b.all();
    const std::vector<T> none(a.size(), T(-1));
    for (const rounding mode : {rounding::nearest, rounding::downward, rounding::upward}) {
        std::vector<T> expected, with_one;
        for (std::size_t i = 0; i < a.size(); ++i) {
            expected.push_back(scalar_time(a[i], b[i], mode));
            with_one.push_back(scalar_time(a[i], b[0], mode));
        }
        CHECK(same_bits(times_of(p.a.columns(), p.b.columns(), mode, none), expected));
        CHECK(same_bits(times_of(a, b, mode, none), expected));
        CHECK(same_bits(times_of(p.a.columns(), b[0], mode, none), with_one));
    }
}

template <int N, class T>
void check_all() {
    check(batches::draw<N, T>(1, 4'000, 60, batches::units::own));
    check(batches::draw<N, T>(2, 2'000, 32, batches::units::any));
    check(batches::draw<N, T>(3, 2'000, 4, batches::units::own));
    for (std::size_t size = 1; size < 20; ++size) {
        check(batches::draw<N, T>(3 + size, size, 32, batches::units::own));
    }
}

} // namespace

TEST_CASE("The times of a batch are those of the scalar functions") {
    check_all<2, double>();
    check_all<3, double>();
    check_all<2, float>();
    check_all<3, float>();
}

TEST_CASE("The oracle rounds to the same times") {
    const auto p = batches::draw<3, double>(4, 700, 32, batches::units::own);
    const auto& a = p.a.all();
    const std::vector<double> none(a.size());
    const auto nearest = times_of(p.a.columns(), p.b.columns(), rounding::nearest, none);
    const auto lower = times_of(p.a.columns(), p.b.columns(), rounding::downward, none);
    const auto upper = times_of(p.a.columns(), p.b.columns(), rounding::upward, none);
    int times = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const oracle::answer truth = oracle::meet(a[i], p.b.all()[i]);
        if (truth.time) {
            ++times;
            CHECK(nearest[i] == oracle::nearest_double(*truth.time));
            CHECK(oracle::compare(*truth.time, mpq_class(lower[i])) >= 0);
            CHECK(oracle::compare(*truth.time, mpq_class(upper[i])) <= 0);
            CHECK((lower[i] == upper[i] || std::nextafter(lower[i], upper[i]) == upper[i]));
        } else {
            CHECK(nearest[i] == std::numeric_limits<double>::infinity());
        }
    }
    CHECK(times > 100);
}

TEST_CASE("Against a plane and a wall, and of integers") {
    const auto p = batches::draw<3, double>(5, 300, 32, batches::units::own);
    const graze::plane<3> floor{{0, 0, 0.1}, {0.25, 0, 1}};
    const graze::wall<3> wall{{-1, -1, 0}, {{{2, 0, 0.5}, {0, 2, 0}}}};
    std::vector<double> with_plane, with_wall;
    for (const auto& b : p.a.all()) {
        with_plane.push_back(scalar_time(b, floor, rounding::nearest));
        with_wall.push_back(scalar_time(b, wall, rounding::nearest));
    }
    const std::vector<double> none(300);
    CHECK(same_bits(times_of(p.a.columns(), floor, rounding::nearest, none), with_plane));
    CHECK(same_bits(times_of(p.a.all(), wall, rounding::nearest, none), with_wall));

    // Many blocks in a row of balls that hit the wall, among others; lanes are asked about some of them.
    std::vector<graze::ball<3>> many;
    std::vector<double> expected;
    for (std::size_t i = 0; i < 12'000; ++i) {
        graze::ball<3> b = p.a.all()[i % 300];
        if (i % 5'000 < 3'000) {
            b = {{b.position[0] / 8, b.position[1] / 8, 40}, {0, 0, -1 - b.radius}, 0.25};
        }
        many.push_back(b);
        expected.push_back(scalar_time(b, wall, rounding::nearest));
    }
    CHECK(same_bits(times_of(many, wall, rounding::nearest, std::vector<double>(many.size())), expected));
    std::vector<graze::encounter> what(many.size());
    graze::batch::classify(many, wall, what);
    for (std::size_t i = 0; i < many.size(); ++i) {
        REQUIRE(what[i] == graze::classify(many[i], wall));
    }

    const std::vector<graze::ball<2, std::int32_t>> a{{{0, 0}, {3, 0}, 1}}, b{{{9, 0}, {0, 0}, 1}};
    CHECK(times_of(a, b, rounding::nearest, std::vector<double>(1)) == std::vector<double>{7.0 / 3});
}

TEST_CASE("Bad input is told with its pair, and times before it are written") {
    auto a = batches::draw<2, float>(6, 600, 60, batches::units::own).a.all();
    const auto b = batches::draw<2, float>(6, 600, 60, batches::units::own).b.all();
    const auto good = times_of(a, b, rounding::nearest, std::vector<float>(600));
    a[300].velocity[1] = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> time(600, -1.0F);
    std::string message;
    try {
        graze::batch::time_of_impact(a, b, time);
    } catch (const std::domain_error& e) {
        message = e.what();
    }
    CHECK(message == "pair 300: ball a: velocity is not finite");
    CHECK(same_bits(std::vector<float>(time.begin(), time.begin() + 300),
                    std::vector<float>(good.begin(), good.begin() + 300)));
}
