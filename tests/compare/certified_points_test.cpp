// A point among walls in certified runs, against the oracle in rationals.
#include "../scene/point_checks.hpp"
#include "../scene/sliding_scenes.hpp"
#include "run/certified_run.hpp"

#include <doctest/doctest.h>

namespace certified_points_test {

using namespace compare;
using namespace compare::run;

namespace {

template <int N>
graze::vec<N, exact> exactly(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return exact(x[i]); });
}

template <int N>
certified_result<N> proved(const point_scene<N>& s, std::size_t most) {
    exact_scene<N> scene;
    const auto& p = s.point.front();
    scene.balls.push_back({{exactly<N>(p.position), exactly<N>(p.velocity), 0, 1}, 1});
    for (const auto& w : s.walls) {
        graze::wall<N, exact> wall{exactly<N>(w.corner), {}};
        std::ranges::transform(w.edge, wall.edge.begin(), exactly<N>);
        scene.walls.push_back(wall);
    }
    return certified_run<N>(scene, {{}, most}, {15, 1L << 12U}, progress_line(false));
}

template <int N>
std::string fault_of(const point_scene<N>& s) {
    const auto found = proved<N>(s, 12);
    if (!found.problem.empty()) {
        return found.problem;
    }
    std::vector<told_bounce> told;
    graze::vec<N, double> before = s.point.front().velocity;
    for (const auto& e : found.events) {
        const auto u = graze::make_vec<N>([&](int i) { return near_double(e.a.velocity[i]); });
        told.push_back({static_cast<std::size_t>(e.who.b), {}, near_double(e.time), u != before});
        std::copy(u.component, u.component + N, told.back().velocity.component);
        before = u;
    }
    return fault_by_oracle<N>(s, told, 12, nullptr);
}

} // namespace

TEST_CASE("a certified point meets what the oracle says") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        CHECK(fault_of<2>(any_point_scene<2>(seed, seed % 2 == 0)) == "");
        CHECK(fault_of<3>(any_point_scene<3>(seed, seed % 2 == 0)) == "");
    }
    for (const std::uint64_t seed : {5423, 5465, 5545}) { // once judged wrongly: the point comes round a border
        CHECK(fault_of<2>(any_point_scene<2>(seed, seed % 2 == 0)) == "");
    }
    for (const std::uint64_t seed : {5103, 5398, 5467, 5490}) {
        CHECK(fault_of<3>(any_point_scene<3>(seed, seed % 2 == 0)) == "");
    }
}

TEST_CASE("a certified point that has come to slide above a floor stays above it") {
    for (const auto& s : sliding_scenes()) {
        CHECK(fault_of<2>(s) == "");
    }
    CHECK(fault_of<3>(raised(sliding_scenes().front())) == "");
    CHECK(fault_of<3>(raised(sliding_scenes().back())) == "");
}

// A point bounces off the upper side of a wall, goes round it and comes to its lower side.
TEST_CASE("a certified point meets a wall on its other side too") {
    const point_scene<2> s{{{{{0, 2}}, {{0, -1}}, 0, 1}},
                           {{{{-1, 0}}, {{{{2, 0}}}}},     // the wall in question
                            {{{-1, 3}}, {{{{2, 2}}}}},     // leads to the right,
                            {{{3, 5}}, {{{{2, -2}}}}},     // down,
                            {{{3, -5}}, {{{{2, 2}}}}},     // to the left
                            {{{-1, -3}}, {{{{2, -2}}}}}}}; // and up
    CHECK(fault_of<2>(s) == "");
    const auto found = proved<2>(s, 12);
    REQUIRE(found.events.size() > 5);
    CHECK(found.events[0].who.b == 0);
    CHECK(found.events[5].who.b == 0);
}

} // namespace certified_points_test
