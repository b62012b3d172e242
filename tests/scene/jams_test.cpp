// Balls whose events never end, and overlaps at the start.
#include "exact_runs.hpp"

#include <graze/scene/overlapping.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>

namespace {

using balls = std::vector<graze::ball<2>>;
using planes = std::vector<graze::plane<2>>;
using walls = std::vector<graze::wall<2>>;
using participants = std::vector<graze::participant>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr auto ball = graze::partner::ball;

// A slot of 0.9 with a ball of diameter 1, and a ball far away between two planes.
const walls slot = {{{{-5, -0.45}}, {{{{10, 0}}}}}, {{{-5, 0.45}}, {{{{10, 0}}}}}};
const balls jammed = {{{{0, 0}}, {{1, 0x1p-10}}, 0.5, 1}, {{{100, 10}}, {{1, 0}}, 0.5, 1}};
const planes ends = {{{{90, 0}}, {{1, 0}}}, {{{110, 0}}, {{1, 0}}}};

// A mirror that presses a ball against a plane.
const balls pressed = {
    {{{-3, 0}}, {{1, 0}}, 0.5, infinite}, {{{-1, 0}}, {{0, 0}}, 0.5, 1}, {{{-100, 10}}, {{-1, 0}}, 0.5, 1}};
const planes press = {{{{0, 0}}, {{1, 0}}}, {{{-110, 0}}, {{1, 0}}}};

} // namespace

TEST_CASE("a ball in too narrow a slot is named") {
    const auto finished = run_exactly<2>({jammed, ends, slot}, {.time = 50});
    CHECK(finished.outcome.why == graze::ending::cascade);
    participants named = finished.outcome.jammed;
    std::sort(named.begin(), named.end());
    CHECK(named == participants{{ball, 0}, {graze::partner::wall, 0}, {graze::partner::wall, 1}});
}

TEST_CASE("a ball that a mirror presses to a plane is named before two million events") {
    const auto finished = run_exactly<2>({pressed, press, {}}, {.time = 50});
    CHECK(finished.outcome.why == graze::ending::cascade);
    CHECK(finished.outcome.events < 2'000'000);
    participants named = finished.outcome.jammed;
    std::sort(named.begin(), named.end());
    CHECK(named == participants{{ball, 0}, {ball, 1}, {graze::partner::plane, 0}});
    // With a smaller limit of events in a row, the run ends earlier.
    const auto earlier = run_exactly<2>({pressed, press, {}}, {.time = 50, .jam = 1000});
    CHECK(earlier.outcome.why == graze::ending::cascade);
    CHECK(earlier.outcome.events < finished.outcome.events);
}

TEST_CASE("a ball that a mirror presses into a groove is named with both sides of it") {
    const balls three = {
        {{{0, 5}}, {{0, -1}}, 1, infinite}, {{{0.1, 1.3}}, {{0, 0}}, 0.5, 1}, {{{100, 0}}, {{1, 0}}, 0.5, 1}};
    const planes groove = {{{{0, 0}}, {{1, 1}}}, {{{0, 0}}, {{-1, 1}}}};
    const auto finished = run_exactly<2>({three, groove, {}}, {.events = 2'000'000});
    CHECK(finished.outcome.why == graze::ending::cascade);
    participants named = finished.outcome.jammed;
    std::sort(named.begin(), named.end());
    CHECK(named == participants{{ball, 0}, {ball, 1}, {graze::partner::plane, 0}, {graze::partner::plane, 1}});
}

TEST_CASE("a ball that two mirrors press is named with both, and stops if one wants") {
    const balls two = {{{{-3, 0}}, {{1, 0}}, 0.5, infinite},
                       {{{0, 0}}, {{0, 0}}, 0.5, 1},
                       {{{3, 0}}, {{-1, 0}}, 0.5, infinite},
                       {{{90, 10}}, {{-1, 0}}, 0.5, 1}};
    auto finished = run_exactly<2>({two, {}, {}}, {.time = 2.25});
    CHECK(finished.outcome.why == graze::ending::cascade);
    participants named = finished.outcome.jammed;
    std::sort(named.begin(), named.end());
    CHECK(named == participants{{ball, 0}, {ball, 1}, {ball, 2}});
    finished = run_exactly<2>({two, {}, {}}, {.time = 2.25, .events = 100'000, .stop_jams = true});
    named = finished.outcome.jammed;
    std::sort(named.begin(), named.end());
    CHECK(named == participants{{ball, 0}, {ball, 1}, {ball, 2}});
    CHECK(finished.flights[1].state.velocity == graze::vec<2, double>{{0, 0}});
    CHECK(finished.outcome.events < 10'000);
}

TEST_CASE("what is jammed stops if one wants, and the others go on until they meet it") {
    auto finished = run_exactly<2>({jammed, ends, slot}, {.time = 50, .stop_jams = true});
    CHECK(finished.outcome.why == graze::ending::time);
    CHECK(finished.outcome.jammed.size() == 3);
    CHECK(finished.flights[0].state.velocity == graze::vec<2, double>{{0, 0}});
    CHECK(finished.flights[1].since == 9.5 + 2 * 19); // at 9.5, 28.5, 47.5

    finished = run_exactly<2>({pressed, press, {}}, {.time = 30, .jam = 1000, .stop_jams = true});
    CHECK(finished.outcome.why == graze::ending::time);
    CHECK(finished.flights[2].since == 9.5);

    balls three = jammed;
    three.push_back({{{4, 0}}, {{-1, 0}}, 0.125, 1}); // it flies into the slot
    finished = run_exactly<2>({three, ends, slot}, {.time = 50, .stop_jams = true});
    CHECK(finished.outcome.why == graze::ending::cascade);
    participants named = finished.outcome.jammed;
    CHECK(std::find(named.begin(), named.end(), graze::participant{ball, 2}) != named.end());
    CHECK(finished.flights[1].since == 0); // 3.375 is before 9.5
}

TEST_CASE("the pairs that overlap at the start are those of all pairs") {
    std::mt19937_64 random(3);
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
    };
    std::size_t found = 0;
    for (int round = 0; round < 100; ++round) {
        balls some;
        for (int i = 0; i < 20; ++i) { // on a grid of integers, where many touch
            some.push_back(
                {{{double(between(-20, 20)), double(between(-20, 20))}}, {{0, 0}}, double(between(0, 5)), 1});
        }
        const planes flat = {{{{0, 15}}, {{0, 2}}}};
        const walls upright = {{{{3, -4}}, {{{{0, 8}}}}}};
        std::vector<graze::scene_pair> expected;
        for (int i = 0; i < 20; ++i) {
            for (int j = i + 1; j < 20; ++j) {
                const auto &a = some[static_cast<std::size_t>(i)], &b = some[static_cast<std::size_t>(j)];
                const double x = a.position[0] - b.position[0], y = a.position[1] - b.position[1];
                const double reach = a.radius + b.radius;
                if (x * x + y * y < reach * reach) {
                    expected.push_back({ball, i, j});
                }
            }
        }
        for (int i = 0; i < 20; ++i) {
            const auto& a = some[static_cast<std::size_t>(i)];
            if (std::abs(a.position[1] - 15) < a.radius) {
                expected.push_back({graze::partner::plane, i, 0});
            }
        }
        for (int i = 0; i < 20; ++i) {
            const auto& a = some[static_cast<std::size_t>(i)];
            const double x = a.position[0] - 3, y = a.position[1] - std::clamp(a.position[1], -4.0, 4.0);
            if (x * x + y * y < a.radius * a.radius) {
                expected.push_back({graze::partner::wall, i, 0});
            }
        }
        CHECK(graze::overlapping(graze::scene<2>{some, flat, upright}) == expected);
        found += expected.size();
    }
    CHECK(found > 1000);
}
