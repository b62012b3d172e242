// The sequence of events, compared with an oracle that shares no code with the library. It depends on the scene alone.
#include "exact_runs.hpp"
#include "line_oracle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

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
        balls.push_back({{{static_cast<double>(b.x), static_cast<double>(b.track) * 16}},
                         {{static_cast<double>(b.v), 0}},
                         static_cast<double>(b.radius),
                         static_cast<double>(b.mass)});
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
    const int tracks = *rc::gen::inRange(1, 4);
    for (int track = 0; track < tracks; ++track) {
        int x = *rc::gen::inRange(0, 3);
        const int count = *rc::gen::inRange(1, 6);
        for (int i = 0; i < count; ++i) {
            const int radius = *rc::gen::inRange(1, 3);
            const int speed = dyadic ? *rc::gen::inRange(-1, 2) : *rc::gen::inRange(-7, 8);
            const int mass = dyadic ? 1 : *rc::gen::inRange(1, 6);
            beads.push_back({x + radius, speed, track, radius, mass});
            x += 2 * radius + *rc::gen::inRange(0, 4);
        }
    }
    for (std::size_t i = beads.size() - 1; i > 0; --i) {
        std::swap(beads[i], beads[*rc::gen::inRange<std::size_t>(0, i + 1)]);
    }
    return beads;
}

} // namespace

TEST_CASE("with ties everywhere, the sequence is the oracle's") {
    CHECK(rc::check([] {
        const auto beads = any_beads(true);
        const auto expected = line_oracle::tracks(beads, 64).run(40);
        const auto told = events_of(beads, 40);
        RC_ASSERT(told.size() == expected.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            RC_ASSERT(told[i].who == expected[i].who);
            RC_ASSERT(rational(told[i].time) == expected[i].time);
            RC_ASSERT(told[i].chosen == expected[i].chosen);
        }
    }));
}

TEST_CASE("with masses of any ratio, the sequence is the oracle's while doubles can tell its times apart") {
    CHECK(rc::check([] {
        const auto beads = any_beads(false);
        const auto expected = line_oracle::tracks(beads, 40).run(30);
        length_of_tracks = 40;
        const auto told = events_of(beads, 30);
        length_of_tracks = 64;
        for (std::size_t i = 0; i < std::min(told.size(), expected.size()); ++i) {
            const bool is_close =
                i + 1 < expected.size() && expected[i + 1].time - expected[i].time < rational(1, 1000000);
            if (is_close) {
                return;
            }
            RC_ASSERT(told[i].who == expected[i].who);
        }
        RC_ASSERT(told.size() == expected.size());
    }));
}

TEST_CASE("the order of the lists has no part in it, nor has the grid") {
    CHECK(rc::check([] {
        const auto beads = any_beads(true);
        std::vector<int> order(beads.size());
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = order.size() - 1; i > 0; --i) {
            std::swap(order[i], order[*rc::gen::inRange<std::size_t>(0, i + 1)]);
        }
        std::vector<bead> permuted;
        for (const int i : order) {
            permuted.push_back(beads[static_cast<std::size_t>(i)]);
        }
        const auto told = events_of(beads, 60);
        const auto other = events_of(permuted, 60, graze::cells::none);
        RC_ASSERT(told.size() == other.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            graze::scene_pair named = other[i].who;
            named.a = order[static_cast<std::size_t>(named.a)];
            named.b = named.with == graze::partner::ball ? order[static_cast<std::size_t>(named.b)] : named.b;
            RC_ASSERT(told[i].who == named);
            RC_ASSERT(told[i].time == other[i].time);
            RC_ASSERT(told[i].chosen == other[i].chosen);
        }
    }));
}

} // namespace sequence_test
