// The sequence of events, compared with an oracle that shares no code with the library. It depends on the scene alone.
#include "../property.hpp"
#include "exact_runs.hpp"
#include "line_oracle.hpp"

#include <doctest/doctest.h>

#include <numeric>

namespace sequence_test {

namespace {

using line_oracle::bead;
using line_oracle::rational;

struct told_event {
    graze::scene_pair who;
    double time;
    bool chosen;
};

double length_of_tracks = 64;

std::vector<told_event> events_of(const std::vector<bead>& beads, std::size_t count,
                                  graze::cells cells = graze::cells::where_useful) {
    std::vector<graze::ball<2>> balls;
    for (const bead& b : beads) {
        balls.push_back({{{b.x.get_d(), b.track * 16.0}}, {{b.v.get_d(), 0}}, b.radius.get_d(), b.mass.get_d()});
    }
    const std::vector<graze::plane<2>> planes = {{{{0, 0}}, {{1, 0}}}, {{{length_of_tracks, 0}}, {{1, 0}}}};
    std::vector<told_event> told;
    (void)run_exactly<2>(
        {balls, planes, {}}, {.events = count},
        [&](const exact_event<2>& e) {
            told.push_back({e.who, static_cast<double>(e.when), e.chosen});
            return true;
        },
        cells);
    return told;
}

// Beads on tracks with gaps of whole numbers, many of them 0. If all have speed 1 or 0 and equal masses, their states
// are always dyadic, and doubles hold them: then every tie is exact.
std::vector<bead> any_beads(bool dyadic) {
    std::vector<bead> beads;
    const int tracks = property::in_range(1, 4);
    for (int track = 0; track < tracks; ++track) {
        int x = property::in_range(0, 3);
        const int count = property::in_range(1, 6);
        for (int i = 0; i < count; ++i) {
            const int radius = property::in_range(1, 3);
            const int speed = dyadic ? property::in_range(-1, 2) : property::in_range(-7, 8);
            const int mass = dyadic ? 1 : property::in_range(1, 6);
            beads.push_back({x + radius, speed, track, radius, mass});
            x += 2 * radius + property::in_range(0, 4);
        }
    }
    for (std::size_t i = beads.size() - 1; i > 0; --i) {
        std::swap(beads[i], beads[property::in_range<std::size_t>(0, i + 1)]);
    }
    return beads;
}

} // namespace

TEST_CASE("with ties everywhere, the sequence is the oracle's") {
    CHECK(property::check([] {
        const auto beads = any_beads(true);
        const auto expected = line_oracle::tracks(beads, 64).run(40);
        const auto told = events_of(beads, 40);
        PROPERTY_ASSERT(told.size() == expected.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            PROPERTY_ASSERT(told[i].who == expected[i].who);
            PROPERTY_ASSERT(rational(told[i].time) == expected[i].time);
            PROPERTY_ASSERT(told[i].chosen == expected[i].chosen);
        }
    }));
}

TEST_CASE("with masses of any ratio, the sequence is the oracle's while doubles can tell its times apart") {
    CHECK(property::check([] {
        const auto beads = any_beads(false);
        const auto expected = line_oracle::tracks(beads, 40).run(31); // one more than is compared: it may be close
        length_of_tracks = 40;
        const auto told = events_of(beads, 30);
        length_of_tracks = 64;
        for (std::size_t i = 0; i < std::min(told.size(), expected.size()); ++i) {
            const bool is_close =
                i + 1 < expected.size() && expected[i + 1].time - expected[i].time < rational(1, 1000000);
            if (is_close) {
                return;
            }
            PROPERTY_ASSERT(told[i].who == expected[i].who);
        }
        PROPERTY_ASSERT(told.size() == std::min<std::size_t>(expected.size(), 30));
    }));
}

TEST_CASE("the order of the lists has no part in it, nor has the grid") {
    CHECK(property::check([] {
        const auto beads = any_beads(true);
        std::vector<int> order(beads.size());
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = order.size() - 1; i > 0; --i) {
            std::swap(order[i], order[property::in_range<std::size_t>(0, i + 1)]);
        }
        std::vector<bead> permuted;
        for (const int i : order) {
            permuted.push_back(beads[static_cast<std::size_t>(i)]);
        }
        const auto told = events_of(beads, 60);
        const auto other = events_of(permuted, 60, graze::cells::none);
        PROPERTY_ASSERT(told.size() == other.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            graze::scene_pair named = other[i].who;
            named.a = order[static_cast<std::size_t>(named.a)];
            named.b = named.with == graze::partner::ball ? order[static_cast<std::size_t>(named.b)] : named.b;
            PROPERTY_ASSERT(told[i].who == named);
            PROPERTY_ASSERT(told[i].time == other[i].time);
            PROPERTY_ASSERT(told[i].chosen == other[i].chosen);
        }
    }));
}

} // namespace sequence_test
