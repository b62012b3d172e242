// Runs of situations in which other programs were reported to be wrong.
#include "exact_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace field_runs_test {

namespace {

template <int N>
using balls = std::vector<graze::ball<N>>;
using walls = std::vector<graze::wall<2>>;

struct happening {
    graze::scene_pair who;
    graze::flight<2> after;
};
std::vector<happening> told(const graze::scene<2>& s, std::uint64_t most) {
    std::vector<happening> result;
    (void)run_exactly<2>(s, {.events = most}, [&](const exact_event<2>& e) {
        result.push_back({e.who, e.after_a});
        return true;
    });
    return result;
}

} // namespace

TEST_CASE("a ball that is aimed into a right-angled corner comes back, and does not leave through the table") {
    const walls cushions = {{{{0, 0}}, {{{{4.5, 0}}}}},
                            {{{0, 4.5}}, {{{{4.5, 0}}}}},
                            {{{0, 0}}, {{{{0, 4.5}}}}},
                            {{{4.5, 0}}, {{{{0, 4.5}}}}}};
    balls<2> ball = {{{{1, 1}}, {{2, 2}}, 0.028575, 1}};
    auto events = told({ball, {}, cushions}, 2);
    REQUIRE(events.size() == 2);
    CHECK(events[0].who.b + events[1].who.b == 1 + 3);
    CHECK(events[0].after.since == events[1].after.since);
    CHECK(events[1].after.since == doctest::Approx(1.7357125).epsilon(1e-15));
    CHECK(events[1].after.state.velocity == graze::vec<2, double>{{-2, -2}});
    CHECK(events[1].after.state.position[0] == events[1].after.state.position[1]);
    // One ulp off the diagonal: the nearer wall is met first, the other one half an ulp later.
    for (const int nearer : {0, 1}) {
        ball[0].position = {{1, 1}};
        ball[0].position[nearer] = std::nextafter(1, 2);
        events = told({ball, {}, cushions}, 2);
        REQUIRE(events.size() == 2);
        CHECK(events[0].who.b == (nearer == 0 ? 3 : 1));
        CHECK(events[1].who.b == (nearer == 0 ? 1 : 3));
        CHECK(events[1].after.state.velocity == graze::vec<2, double>{{-2, -2}});
    }
}

TEST_CASE("no two balls of a tight rack come to be inside each other") {
    const double r = 0.028575;
    for (const double gap : {1e-4, 1e-9, 0.0}) {
        CAPTURE(gap);
        balls<2> all = {{{{-0.5, 0.001}}, {{3, 0}}, r, 1}};
        for (int row = 0; row < 5; ++row) {
            for (int i = 0; i <= row; ++i) {
                const double d = 2 * r + gap;
                all.push_back({{{row * d * std::sqrt(0.75), (i - row / 2.0) * d}}, {{0, 0}}, r, 1});
            }
        }
        const std::vector<graze::plane<2>> cushions = {
            {{{-1, 0}}, {{1, 0}}}, {{{1, 0}}, {{1, 0}}}, {{{0, -0.5}}, {{0, 1}}}, {{{0, 0.5}}, {{0, 1}}}};
        std::vector<graze::flight<2>> now;
        for (const auto& b : all) {
            now.push_back({b, 0});
        }
        double deepest = 0;
        std::size_t events = 0;
        (void)run_exactly<2>({all, cushions, {}}, {.events = 400}, [&](const exact_event<2>& e) {
            now[static_cast<std::size_t>(e.who.a)] = e.after_a;
            if (e.who.with == graze::partner::ball) {
                now[static_cast<std::size_t>(e.who.b)] = *e.after_b;
            }
            ++events;
            const auto at = [&](const graze::flight<2>& f, int i) {
                return static_cast<long double>(f.state.position[i]) +
                       (static_cast<long double>(e.after_a.since) - f.since) * f.state.velocity[i];
            };
            for (std::size_t i = 0; i < now.size(); ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    const long double x = at(now[i], 0) - at(now[k], 0), y = at(now[i], 1) - at(now[k], 1);
                    deepest = std::max(deepest,
                                       static_cast<double>(2 * static_cast<long double>(r) - std::sqrt(x * x + y * y)));
                }
            }
            return true;
        });
        CHECK(events == 400);
        CHECK(deepest < 3e-15);
    }
}

TEST_CASE("two balls and a wall, and cradles, keep their speeds and energy to the last bit") {
    const walls wall = {{{{4, -1}}, {{{{0, 2}}}}}};
    for (const double gap : {0x1p-5, 0.0}) { // from the second ball to the wall, and from the first to the second
        const balls<2> two = {{{{2 - gap, 0}}, {{1, 0}}, 0.5, 1}, {{{3.5 - gap, 0}}, {{0, 0}}, 0.5, 1}};
        const auto finished = run_exactly<2>({two, {}, wall}, {});
        CHECK(finished.outcome.why == graze::ending::exhausted);
        CHECK(finished.outcome.events == 3);
        CHECK(finished.flights[0].state.velocity == graze::vec<2, double>{{-1, 0}});
        CHECK(finished.flights[1].state.velocity == graze::vec<2, double>{{0, 0}});
    }
    for (const double gap : {0x1p-5, 0.0}) {
        for (int moving = 1; moving < 5; ++moving) { // as many balls leave as come
            balls<2> cradle;
            for (int i = 0; i < 5; ++i) {
                const bool comes = i < moving;
                cradle.push_back({{{i * (1 + gap) - (comes ? 1.0 : 0), 0}}, {{comes ? 1.0 : 0, 0}}, 0.5, 1});
            }
            const auto finished = run_exactly<2>({cradle, {}, {}}, {});
            CHECK(finished.outcome.why == graze::ending::exhausted);
            CHECK(finished.outcome.events == static_cast<std::uint64_t>(moving * (5 - moving)));
            for (int i = 0; i < 5; ++i) {
                CHECK(finished.flights[static_cast<std::size_t>(i)].state.velocity ==
                      graze::vec<2, double>{{i >= 5 - moving ? 1.0 : 0, 0}});
            }
        }
    }
}

TEST_CASE("a ray that is aimed at a seam or a tip meets one of the two, never neither") {
    std::mt19937_64 random(5);
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
    };
    const auto cross = [](const graze::vec<2, double>& x, const graze::vec<2, double>& y) {
        return x[0] * y[1] - x[1] * y[0];
    };
    int rays = 0;
    while (rays < 500) {
        const auto any = [&] { return graze::vec<2, double>{{double(between(-9, 9)), double(between(-9, 9))}}; };
        const auto joint = any(), one = any(), u = any();
        const auto other = rays % 2 == 0 ? any() : -1.0 * one; // a tip, or a seam
        if (cross(one, u) == 0 || cross(other, u) == 0 || (rays % 2 == 0 && cross(one, other) == 0)) {
            continue;
        }
        const walls joined = {{joint, {{one}}}, {joint, {{other}}}};
        const auto events = told({balls<2>{{joint - 2.0 * u, u, 0, 1}}, {}, joined}, 9);
        REQUIRE(!events.empty());
        CHECK(events[0].after.since == 2);
        CHECK(events[0].after.state.position == joint);
        ++rays;
    }
}

TEST_CASE("a ball that rolls over a seam is not thrown up; over a step of an ulp, by what the step says") {
    const balls<2> ball = {{{{-1, 0.5}}, {{1, 0}}, 0.5, 1}};
    auto events = told({ball, {}, walls{{{{-4, 0}}, {{{{4, 0}}}}}, {{{0, 0}}, {{{{4, 0}}}}}}}, 9);
    for (const happening& h : events) {
        CHECK(h.after.state.velocity == graze::vec<2, double>{{1, 0}});
    }
    // The second piece higher by δ, an ulp below 1/2: sin² of half the angle of the kick is δ/2r.
    const double step = 0x1p-54;
    events = told({ball, {}, walls{{{{-4, 0}}, {{{{4, 0}}}}}, {{{0, step}}, {{{{4, 0}}}}}}}, 9);
    REQUIRE(!events.empty());
    CHECK(events.back().after.state.velocity[1] == doctest::Approx(2 * std::sqrt(2 * step / 0.5)).epsilon(1e-6));
}

} // namespace field_runs_test
