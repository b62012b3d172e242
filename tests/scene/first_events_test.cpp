// The first events of a scene, with its lists in any order, compared with the oracle and with a look at every pair.
#include "../property.hpp"
#include "line_oracle.hpp"

#include <graze/scene.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace first_events_test {

namespace {

using line_oracle::bead;
using line_oracle::rational;

graze::ball<2> ball_of(const bead& b) {
    return {{{b.x.get_d(), b.track * 16.0}}, {{b.v.get_d(), 0}}, b.radius.get_d(), b.mass.get_d()};
}

// Balls of all sizes among planes and walls, near each other or far apart, some very far away. Many share places and
// velocities with others, so that much happens at the same time.
struct any_scene {
    std::vector<graze::ball<2>> balls;
    std::vector<graze::plane<2>> planes;
    std::vector<graze::wall<2>> walls;

    any_scene() {
        std::mt19937_64 random(property::any<std::uint64_t>());
        const auto below = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
        const int wide = property::one_of(6, 20, 100), fast = property::one_of(1, 4);
        const double unit = std::ldexp(1, property::one_of(0, 0, -30, 600, -600));
        const auto any = [&](int most) {
            return graze::make_vec<2>([&](int) { return (below(2 * most + 1) - most) * unit; });
        };
        const int count = property::in_range(0, 60);
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
    CHECK(property::check([&] {
        std::vector<bead> beads;
        int x = property::in_range(0, 3);
        const int count = property::in_range(1, 9);
        for (int i = 0; i < count; ++i) {
            const int radius = property::in_range(1, 3);
            beads.push_back({x + radius, property::in_range(-2, 3), i % 2, radius, 1});
            x += 2 * radius + property::in_range(0, 3);
        }
        for (std::size_t i = beads.size() - 1; i > 0; --i) {
            std::swap(beads[i], beads[property::in_range<std::size_t>(0, i + 1)]);
        }
        std::vector<graze::ball<2>> balls;
        for (const bead& b : beads) {
            balls.push_back(ball_of(b));
        }
        const auto first = graze::first_events(graze::scene<2>{balls, planes, {}});
        const auto expected = line_oracle::tracks(beads, 64).first();
        PROPERTY_ASSERT(first.events.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            PROPERTY_ASSERT(first.events[i] == expected[i].who);
            const rational& time = expected[i].time; // of small numbers, so their quotient is rounded once
            PROPERTY_ASSERT(static_cast<double>(*first.time) == time.get_num().get_d() / time.get_den().get_d());
        }
        const auto only = graze::first_events(graze::scene<2>{balls, planes, {}}, graze::simultaneous::first);
        PROPERTY_ASSERT(only.events.size() == std::min<std::size_t>(expected.size(), 1));
        if (!expected.empty()) {
            PROPERTY_ASSERT(only.events[0] == expected[0].who);
        }
    }));
}

TEST_CASE("the first events are the first of all") {
    int many = 0, none = 0;
    CHECK(property::check([&] {
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
        PROPERTY_ASSERT(found.events == expected);
        PROPERTY_ASSERT(found.time.has_value() == first.has_value());
        PROPERTY_ASSERT(!first || *found.time == *first);
        many += expected.size() > 1 ? 1 : 0;
        none += first ? 0 : 1;
    }));
    CHECK(many > 10);
    CHECK(none > 0);
}

TEST_CASE("those that overlap are found among all") {
    std::size_t pairs = 0;
    CHECK(property::check([&] {
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
        PROPERTY_ASSERT(graze::overlapping(s.view()) == expected);
        pairs += expected.size();
    }));
    CHECK(pairs > 100);
}

namespace {

// In multiples of 1/8, so that images are where they are exactly; in any period.
struct periodic_scene {
    std::vector<graze::ball<2>> balls;
    std::vector<graze::plane<2>> planes;
    std::vector<graze::wall<2>> walls;
    graze::vec<2, double> period;

    periodic_scene() {
        std::mt19937_64 random(property::any<std::uint64_t>());
        const auto below = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
        const auto any = [&](int most) { return 0.125 * (below(2 * most + 1) - most); };
        const bool slit = below(2) == 0;
        period = {static_cast<double>(4 + below(6)), slit ? 0.0 : 4 + below(6)};
        for (int i = 1 + below(8); i > 0; --i) {
            balls.push_back({{any(80), any(slit ? 40 : 80)}, {any(8), any(8)}, 0.125 * below(8), 1});
        }
        for (int i = below(2) * below(3); i > 0; --i) {
            walls.push_back({{any(60), any(60)}, {{{any(16), 0.125 + 0.125 * below(16)}}}});
        }
        if (slit) {
            planes = {{{0, -6}, {0, 1}}, {{3, 6}, {0, -2}}};
        }
    }
    [[nodiscard]] graze::scene<2> view() const { return {balls, planes, walls, period}; }

    // f(who, ball, image) for each ball and all parts that have images, up to seven periods from themselves.
    template <class F>
    void for_each_image(F f) const {
        const int across = period[1] > 0 ? 7 : 0;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            for (int k = -7; k <= 7; ++k) {
                for (int l = -across; l <= across; ++l) {
                    const graze::vec<2, double> by = {k * period[0], l * period[1]};
                    const auto with = [&](graze::partner kind, std::size_t j) {
                        return graze::scene_pair{kind, static_cast<int>(i), static_cast<int>(j)};
                    };
                    for (std::size_t j = i + 1; j < balls.size(); ++j) {
                        graze::ball<2> there = balls[j];
                        there.position = there.position + by;
                        f(with(graze::partner::ball, j), balls[i], there);
                    }
                    for (std::size_t j = 0; j < walls.size(); ++j) {
                        graze::wall<2> there = walls[j];
                        there.corner = there.corner + by;
                        f(with(graze::partner::wall, j), balls[i], there);
                    }
                    for (std::size_t j = 0; j < planes.size() && k == 0; ++j) {
                        f(with(graze::partner::plane, j), balls[i], planes[j]);
                    }
                }
            }
        }
    }
};

template <class Pairs>
void sort_out(Pairs& pairs) {
    for (graze::scene_pair& m : pairs) {
        if (m.with == graze::partner::ball && m.b < m.a) {
            std::swap(m.a, m.b);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

} // namespace

TEST_CASE("in a scene that has a period the first events and the overlaps are those of copies") {
    int images = 0, several = 0;
    CHECK(property::check([&] {
        const periodic_scene s;
        std::optional<graze::impact_time<2>> first;
        std::vector<graze::scene_pair> expected, inside;
        s.for_each_image([&](const graze::scene_pair& who, const auto& a, const auto& b) {
            if (overlaps(a, b)) {
                inside.push_back(who);
            }
            const auto t = time_of_impact(a, b);
            if (t && (!first || *t < *first)) {
                first = t;
                expected.clear();
            }
            if (t && *t == *first) {
                expected.push_back(who);
            }
        });
        sort_out(expected);
        sort_out(inside);
        PROPERTY_ASSERT(graze::overlapping(s.view()) == inside);
        // Until then two come nearer by a period at most, and none is farther than three from 0.
        if (first && *first < 2.0) {
            auto found = graze::first_events(s.view());
            PROPERTY_ASSERT(found.time.has_value());
            PROPERTY_ASSERT(found.time->compare(*first) == 0);
            const std::size_t named = found.events.size();
            sort_out(found.events);
            PROPERTY_ASSERT(found.events.size() == named);
            PROPERTY_ASSERT(found.events == expected);
            ++images;
            several += named > 1 ? 1 : 0;
        }
    }));
    CHECK(images > 60);
    CHECK(several > 2);
}

// Ball 0 leaves many shells before it comes to ball 1, which is given a period behind; the others lie beside its way.
TEST_CASE("an image far away is met, from either side") {
    for (const double way : {1.0, -1.0}) {
        std::vector<graze::ball<2>> balls = {{{0, 0}, {way, 0}, 0.5, 1}, {{-34 * way, 0}, {0, 0}, 0.5, 1}};
        for (int i = 0; i < 14; ++i) {
            balls.push_back({{4.0 * i, 8}, {0, 0}, 0.5, 1});
        }
        const auto found = graze::first_events(graze::scene<2>{.balls = balls, .period = {64, 0}});
        REQUIRE(found.events.size() == 1);
        CHECK(found.events[0].a + found.events[0].b == 1);
        CHECK(static_cast<double>(*found.time) == 29);
    }
}

TEST_CASE("a ball may be nearly as large as a number can be") {
    for (const double radius : {0x1p1000, 1.6e308, std::numeric_limits<double>::max()}) {
        const std::vector<graze::ball<2>> balls = {
            {{0, 0}, {0, 0}, radius, 1}, {{-3, radius}, {1, 0}, 1, 1}, {{5, 0}, {0, 0}, 1, 1}};
        const auto found = graze::first_events(graze::scene<2>{.balls = balls});
        REQUIRE(found.events.size() == 1);
        CHECK(found.events[0].a == 1);
    }
}

TEST_CASE("balls that all fly alike in a period never meet, and distances that are no number are named") {
    const std::vector<graze::ball<2>> alike = {{{0, 0}, {3, 1}, 0.5, 1}, {{2, 1}, {3, 1}, 0.5, 1}},
                                      tiny = {{{0x1p-600, 0}, {5, 2}, 0.5, 1}, {{0x1p-60, 2}, {0, 0}, 0.5, 1}};
    CHECK(graze::first_events(graze::scene<2>{.balls = alike, .period = {5, 5}}).events.empty());
    CHECK_THROWS_WITH_AS((void)graze::first_events(graze::scene<2>{.balls = tiny, .period = {5, 0}}),
                         "ball 0 and ball 1: a coordinate is too small beside the period for an exact distance",
                         std::range_error);
    const std::vector<graze::wall<2>> thin = {{{1, 1}, {{{1e-200, 0}}}}};
    CHECK_THROWS_WITH_AS((void)graze::overlapping(graze::scene<2>{.walls = thin, .period = {5, 0}}),
                         "wall 0: too thin to say where its images are", std::domain_error);
}

} // namespace first_events_test
