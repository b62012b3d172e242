// The first events of a scene, with its lists in any order, compared with the oracle and with a look at every pair.
#include "line_oracle.hpp"

#include <graze/scene.hpp>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numeric>
#include <random>

namespace first_events_test {

namespace {

using line_oracle::bead;
using line_oracle::rational;

graze::ball<2> ball_of(const bead& b) {
    return {{{static_cast<double>(b.x), static_cast<double>(b.track) * 16}},
            {{static_cast<double>(b.v), 0}},
            static_cast<double>(b.radius),
            static_cast<double>(b.mass)};
}

// Balls of all sizes among planes and walls, near each other or far apart, some very far away. Many share places and
// velocities with others, so that much happens at the same time.
struct any_scene {
    std::vector<graze::ball<2>> balls;
    std::vector<graze::plane<2>> planes;
    std::vector<graze::wall<2>> walls;

    any_scene() {
        std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
        const auto below = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
        const int wide = *rc::gen::element(6, 20, 100), fast = *rc::gen::element(1, 4);
        const double unit = std::ldexp(1, *rc::gen::element(0, 0, -30, 600, -600));
        const auto any = [&](int most) {
            return graze::make_vec<2>([&](int) { return (below(2 * most + 1) - most) * unit; });
        };
        const int count = *rc::gen::inRange(0, 60);
        for (int i = 0; i < count; ++i) {
            const double size = below(8) == 0 ? std::ldexp(unit, below(12) - 8) : unit * below(3);
            balls.push_back({any(below(20) == 0 ? 1000 * wide : wide), any(fast), size, 1});
        }
        for (int i = below(3); i > 0; --i) {
            planes.push_back({any(2 * wide), {unit * (1 + below(2)), unit * below(2)}});
        }
        for (int i = below(2) * below(14); i > 0; --i) {
            walls.push_back({any(wide), {{{unit * (1 + below(3)), unit * below(3)}}}});
        }
    }
    [[nodiscard]] graze::scene<2> view() const { return {balls, planes, walls}; }
};

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

TEST_CASE("the first events are the first of all") {
    int many = 0, none = 0;
    CHECK(rc::check([&] {
        const any_scene s;
        std::optional<graze::impact_time<2>> first;
        std::vector<graze::scene_pair> expected;
        const auto offer = [&](const std::optional<graze::impact_time<2>>& t, const graze::scene_pair& who) {
            if (t && (!first || *t < *first)) {
                first = t;
                expected.clear();
            }
            if (t && *t == *first) {
                expected.push_back(who);
            }
        };
        const auto meet = [&](graze::partner kind, const auto& parts, int i) {
            for (int j = 0; j < static_cast<int>(parts.size()); ++j) {
                offer(time_of_impact(s.balls[static_cast<std::size_t>(i)], parts[static_cast<std::size_t>(j)]),
                      {kind, i, j});
            }
        };
        for (int i = 0; i < static_cast<int>(s.balls.size()); ++i) {
            const auto& a = s.balls[static_cast<std::size_t>(i)];
            for (int j = i + 1; j < static_cast<int>(s.balls.size()); ++j) {
                offer(time_of_impact(a, s.balls[static_cast<std::size_t>(j)]), {graze::partner::ball, i, j});
            }
            meet(graze::partner::plane, s.planes, i);
            meet(graze::partner::wall, s.walls, i);
        }
        auto found = graze::first_events(s.view());
        for (graze::scene_pair& m : found.events) {
            if (m.with == graze::partner::ball && m.b < m.a) {
                std::swap(m.a, m.b);
            }
        }
        std::sort(found.events.begin(), found.events.end());
        std::sort(expected.begin(), expected.end());
        RC_ASSERT(found.events == expected);
        RC_ASSERT(found.time.has_value() == first.has_value());
        RC_ASSERT(!first || *found.time == *first);
        many += expected.size() > 1 ? 1 : 0;
        none += first ? 0 : 1;
    }));
    CHECK(many > 10);
    CHECK(none > 0);
}

TEST_CASE("those that overlap are found among all") {
    std::size_t pairs = 0;
    CHECK(rc::check([&] {
        const any_scene s;
        std::vector<graze::scene_pair> expected;
        const auto look = [&](graze::partner kind, const auto& parts) {
            for (int i = 0; i < static_cast<int>(s.balls.size()); ++i) {
                for (int j = kind == graze::partner::ball ? i + 1 : 0; j < static_cast<int>(parts.size()); ++j) {
                    if (overlaps(s.balls[static_cast<std::size_t>(i)], parts[static_cast<std::size_t>(j)])) {
                        expected.push_back({kind, i, j});
                    }
                }
            }
        };
        look(graze::partner::ball, s.balls);
        look(graze::partner::plane, s.planes);
        look(graze::partner::wall, s.walls);
        RC_ASSERT(graze::overlapping(s.view()) == expected);
        pairs += expected.size();
    }));
    CHECK(pairs > 100);
}

} // namespace first_events_test
