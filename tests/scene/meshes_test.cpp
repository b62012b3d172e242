// Triangles in scenes and runs: inner edges, points on seams, permuted lists.
#include "exact_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

TEST_CASE("Nothing is met at a mesh's inner edges, and what else is met stays") {
    using graze::triangle;
    const std::vector<triangle<double>> floor = {{{0, 0, 0}, {{{4, 0, 0}, {0, 4, 0}}}},
                                                 {{4, 4, 0}, {{{-4, 0, 0}, {0, -4, 0}}}}};
    const std::vector<std::uint8_t> seams = {0b010, 0b010};
    const auto met = [&](const graze::ball<3>& b, bool marked) {
        const std::vector<graze::ball<3>> balls{b};
        graze::scene<3> s{.balls = balls, .triangles = floor};
        if (marked) {
            s.inner_edges = seams;
        }
        std::vector<graze::scene_pair> events;
        (void)run_exactly<3>(s, {.events = 1}, [&](const auto& e) {
            events.push_back(e.who);
            return true;
        });
        return events;
    };
    using graze::partner;
    // Over the seam but too low, along the seam onto its corner, from outside onto an outer edge, down onto a face, and
    // down onto the seam.
    CHECK(met({{1, 1, 0.499}, {1, 1, 0}, 0.5}, false) == std::vector{graze::scene_pair{partner::triangle, 0, 1}});
    CHECK(met({{1, 1, 0.499}, {1, 1, 0}, 0.5}, true).empty());
    CHECK(met({{5, -1, 0.25}, {-1, 1, 0}, 0.5}, false).size() == 1);
    CHECK(met({{5, -1, 0.25}, {-1, 1, 0}, 0.5}, true).empty());
    CHECK(met({{1, -2, 0.25}, {0, 1, 0}, 0.5}, true) == std::vector{graze::scene_pair{partner::triangle, 0, 0}});
    CHECK(met({{1, 1, 3}, {0, 0, -1}, 0.5}, true) == std::vector{graze::scene_pair{partner::triangle, 0, 0}});
    CHECK(met({{2, 2, 3}, {0, 0, -1}, 0.5}, true).size() == 1);
}

TEST_CASE("A point bounces off the triangles of a mesh once, on their seam too, and a scene's lists may be permuted") {
    using graze::triangle;
    std::vector<triangle<double>> floor = {{{0, 0, 0}, {{{4, 0, 0}, {0, 4, 0}}}},
                                           {{4, 4, 0}, {{{-4, 0, 0}, {0, -4, 0}}}}};
    const std::vector<graze::ball<3>> balls = {{{1, 1, 1}, {0.5, 0.5, -1}, 0}, {{2, 2, 2}, {0, 0, -1}, 0}};
    const auto states = [&] {
        const auto done = run_exactly<3>({.balls = balls, .triangles = floor}, {});
        CHECK(done.outcome.events == 2);
        std::vector<double> all;
        for (const auto& f : done.flights) {
            const auto& x = f.state;
            all.insert(all.end(), {x.position[0], x.position[1], x.position[2], x.velocity[2]});
        }
        return all;
    };
    const auto once = states();
    CHECK(once == std::vector<double>{1.5, 1.5, 0, 1, 2, 2, 0, 1});
    std::swap(floor[0], floor[1]);
    CHECK(states() == once);
}

TEST_CASE("Marks of inner edges that no triangle has are named") {
    const std::vector<graze::triangle<double>> one = {{{0, 0, 0}, {{{4, 0, 0}, {0, 4, 0}}}}};
    const std::vector<std::uint8_t> two = {0, 0}, large = {8};
    CHECK_THROWS_WITH_AS(check(graze::scene<3>{.triangles = one, .inner_edges = two}),
                         "inner_edges: not one for each triangle", std::domain_error);
    CHECK_THROWS_WITH_AS(check(graze::scene<3>{.triangles = one, .inner_edges = large}),
                         "inner_edges of triangle 0: a triangle has three edges", std::domain_error);
}
