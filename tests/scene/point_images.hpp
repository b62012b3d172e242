// A point among walls in a space with a period, compared with the same point among copies of these walls.
#pragma once

#include "point_checks.hpp"

#include <algorithm>

// What happens at one time.
struct told_instant {
    double time;
    graze::vec<3, double> velocity; // after all events of that time
    std::size_t first;              // the wall that is met first
    bool chosen;                    // whether that was a choice
};

// What is wrong with the first events of a run with that period along the axis, as long as all states are multiples of
// 2^-20 and so exact; empty if nothing is. compared: how many instants have been compared. Which of several walls is
// the first may depend on the order of the walls' numbers, which copies change: there the comparison ends.
template <int N>
[[nodiscard]] std::string fault_beside_copies(const point_scene<N>& s, int axis, double length, std::size_t* compared) {
    constexpr std::uint64_t most = 12;
    constexpr int copies = 6;
    graze::vec<N, double> period{};
    period[axis] = length;
    const graze::scene<N> periodic{.balls = s.point, .walls = s.walls, .period = period};
    try {
        graze::check(periodic);
    } catch (const std::domain_error&) { // a wall is longer than the period
        return "";
    }
    std::vector<graze::wall<N>> many;
    for (int k = -copies; k <= copies; ++k) {
        for (graze::wall<N> w : s.walls) {
            w.corner[axis] += k * length;
            many.push_back(w);
        }
    }
    const auto is_on_grid = [](double x) { return std::ldexp(x, 20) == std::rint(std::ldexp(x, 20)); };
    const auto instants_of = [&](const graze::scene<N>& scene) {
        std::vector<told_instant> told;
        double gone = 0; // how far the point has been brought back
        bool ends = false;
        (void)run_exactly<N>(scene, {.events = most}, [&](const exact_event<N>& e) {
            const graze::flight<N>&before = e.before_a, &after = e.after_a;
            graze::vec<3, double> u{};
            ends = !is_on_grid(after.since);
            for (int i = 0; i < N; ++i) {
                u[i] = after.state.velocity[i];
                ends = ends || !is_on_grid(after.state.position[i]) || !is_on_grid(u[i]);
            }
            gone += before.state.position[axis] + before.state.velocity[axis] * (after.since - before.since) -
                    after.state.position[axis];
            ends = ends || std::fabs(after.state.position[axis] + gone) > (copies - 2) * length;
            if (told.empty() || told.back().time != after.since) {
                told.push_back({after.since, u, static_cast<std::size_t>(e.who.b) % s.walls.size(), e.chosen});
            }
            told.back().velocity = u;
            return !ends;
        });
        if (!told.empty()) { // it may not be complete
            told.pop_back();
        }
        return std::pair(told, ends);
    };
    const auto [found, end_of_found] = instants_of(periodic);
    const auto [expected, end_of_expected] = instants_of({.balls = s.point, .walls = many});
    for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
        if (found[i].time != expected[i].time) {
            return "instant " + std::to_string(i) + " is at another time than among copies";
        }
        if (found[i].first != expected[i].first && found[i].chosen && expected[i].chosen) {
            return "";
        }
        if (found[i].first != expected[i].first || !(found[i].velocity == expected[i].velocity)) {
            return "instant " + std::to_string(i) + " is another one than among copies";
        }
        ++*compared;
    }
    return found.empty() != expected.empty() && !end_of_found && !end_of_expected ? "one of them meets nothing" : "";
}
