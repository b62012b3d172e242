// Runs in the debug mode of the standard library, which checks each iterator and index.
#include <graze/graze.hpp>
#include <graze/run.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

TEST_CASE("Galperin's masses meet each other and a wall 314 times") {
    const std::vector<graze::ball<2>> two = {{{{2, 0}}, {{0, 0}}, 0.5, 1}, {{{5, 0}}, {{-1, 0}}, 0.5, 10000}};
    const std::vector<graze::plane<2>> upright = {{{{0, 0}}, {{1, 0}}}};
    graze::run run(graze::scene<2>{two, upright, {}});
    static_assert(std::is_same_v<decltype(run), graze::run<graze::exact_mechanics<2>>>);
    CHECK(run.advance({}).events == 314);
}

TEST_CASE("balls of many sizes pass through cells and lose no energy") {
    std::mt19937_64 random(3);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    std::vector<graze::ball<2>> balls;
    double energy = 0;
    for (int i = 0; i < 144; ++i) {
        const graze::vec<2, double> at = {{2.0 * (i % 12) + 1, 2.0 * (i / 12) + 1}};
        balls.push_back({at, {{between(-1, 1), between(-1, 1)}}, i % 3 == 0 ? 0.05 : between(0.2, 0.9), 1});
        energy += squared_norm(balls.back().velocity);
    }
    const std::vector<graze::plane<2>> box = {
        {{{0, 0}}, {{1, 0}}}, {{{0, 0}}, {{0, 1}}}, {{{24, 24}}, {{1, 0}}}, {{{24, 24}}, {{0, 1}}}};
    graze::run<graze::exact_mechanics<2>> run(graze::scene<2>{balls, box, {}});
    constexpr int events = 400;
    CHECK(run.advance({.events = events}).events == events);
    double left = energy;
    for (int i = 0; i < run.balls(); ++i) {
        left -= squared_norm(run.in_flight(i).state.velocity);
    }
    // An event rounds each component of two velocities once; so does each sum here.
    CHECK(std::fabs(left) < (events + 4 * run.balls()) * 0x1p-51 * energy);
}

TEST_CASE("floats, of which no outlines are kept, run in large scenes") {
    std::vector<graze::ball<2, float>> balls;
    for (int i = 0; i < 4900; ++i) {
        const auto x = static_cast<float>(i % 70), y = static_cast<float>(i / 70);
        balls.push_back({{{x, y}}, {{i % 2 == 0 ? 0.5f : -0.5f, 0.25f}}, 0.3f, 1});
    }
    graze::run<graze::exact_mechanics<2, float>> run(graze::scene<2, float>{balls, {}, {}});
    CHECK(run.advance({.events = 20}).events == 20);
}
