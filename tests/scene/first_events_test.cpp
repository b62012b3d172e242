// The first events of a scene, against the oracle, in any order of its lists.
#include "line_oracle.hpp"

#include <graze/scene/first_events.hpp>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <numeric>

namespace {

using line_oracle::bead;
using line_oracle::rational;

graze::ball<2> ball_of(const bead& b) {
    return {{{static_cast<double>(b.x), static_cast<double>(b.track) * 16}},
            {{static_cast<double>(b.v), 0}},
            static_cast<double>(b.radius),
            static_cast<double>(b.mass)};
}

} // namespace

TEST_CASE("nothing is first where nothing happens") {
    CHECK(graze::first_events(graze::scene<2>{}).events.empty());
    const std::vector<graze::ball<2>> one = {{{{0, 0}}, {{1, 0}}, 1, 1}};
    const auto first = graze::first_events(graze::scene<2>{one, {}, {}});
    CHECK(first.events.empty());
    CHECK(!first.time);
}

TEST_CASE("bad input is named") {
    const std::vector<graze::ball<2>> two = {{{{0, 0}}, {{1, 0}}, 1, 1}, {{{9, 0}}, {{1, 0}}, -1, 1}};
    CHECK_THROWS_WITH_AS((void)graze::first_events(graze::scene<2>{two, {}, {}}), "ball 1: radius is negative",
                         std::domain_error);
}

TEST_CASE("all events of the earliest time, as the oracle has them, whatever the order of the lists") {
    const std::vector<graze::plane<2>> planes = {{{{0, 0}}, {{1, 0}}}, {{{64, 0}}, {{-3, 0}}}};
    CHECK(rc::check([&] {
        std::vector<bead> beads;
        int x = *rc::gen::inRange(0, 3);
        const int count = *rc::gen::inRange(1, 9);
        for (int i = 0; i < count; ++i) {
            const int radius = *rc::gen::inRange(1, 3);
            beads.push_back({x + radius, *rc::gen::inRange(-2, 3), i % 2, radius, 1});
            x += 2 * radius + *rc::gen::inRange(0, 3);
        }
        for (std::size_t i = beads.size() - 1; i > 0; --i) {
            std::swap(beads[i], beads[*rc::gen::inRange<std::size_t>(0, i + 1)]);
        }
        std::vector<graze::ball<2>> balls;
        for (const bead& b : beads) {
            balls.push_back(ball_of(b));
        }
        const auto first = graze::first_events(graze::scene<2>{balls, planes, {}});
        const auto expected = line_oracle::tracks(beads, 64).first();
        RC_ASSERT(first.events.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            RC_ASSERT(first.events[i] == expected[i].who);
            RC_ASSERT(rational(static_cast<double>(*first.time)) ==
                      rational(static_cast<double>(expected[i].time))); // rounded once
        }
        const auto only = graze::first_events(graze::scene<2>{balls, planes, {}}, graze::simultaneous::first);
        RC_ASSERT(only.events.size() == std::min<std::size_t>(expected.size(), 1));
        if (!expected.empty()) {
            RC_ASSERT(only.events[0] == expected[0].who);
        }
    }));
}
