// Random scenes, and whether their runs equal those by brute force, event by event and digit by digit.
#pragma once

#include "brute_force.hpp"
#include "exact_runs.hpp"

#include <random>
#include <string>
#include <vector>

namespace brute_force {

template <int N>
struct drawn_scene {
    std::vector<graze::ball<N>> balls;
    std::vector<graze::plane<N>> planes;
    std::vector<graze::wall<N>> walls;
    graze::vec<N, double> period{};

    // Balls of many sizes between planes, among walls or in a periodic space; none overlaps another at the start.
    explicit drawn_scene(std::mt19937_64& random) {
        const auto any = [&](double low, double high) {
            return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
        };
        const double length = any(4, 12);
        for (int i = 0; i < N; ++i) {
            if (random() % 2 == 0) {
                period.component[i] = length * any(0.7, 1);
            } else if (random() % 4 != 0) {
                for (const double at : {0.0, length}) {
                    graze::plane<N> p{};
                    p.normal[i] = at == 0 ? 3 : -1;
                    p.point[i] = at;
                    planes.push_back(p);
                }
            }
        }
        if (N == 2 && period == graze::vec<N, double>{}) {
            for (auto i = random() % 3; i > 0; --i) {
                walls.push_back({graze::make_vec<N>([&](int) { return any(0, length); }),
                                 {graze::make_vec<N>([&](int) { return any(-2, 2); })}});
            }
        }
        const auto count = 1 + random() % (N == 2 ? 7 : 9);
        for (int tries = 0; tries < 60 && balls.size() < count; ++tries) {
            graze::ball<N> b{};
            b.radius = any(0.1, 1);
            b.mass = any(0.5, 2);
            for (int i = 0; i < N; ++i) {
                b.position[i] = any(b.radius, length - b.radius);
                b.velocity[i] = any(-1, 1);
            }
            if (is_free(b)) {
                balls.push_back(b);
            }
        }
    }
    [[nodiscard]] graze::scene<N> view() const {
        graze::scene<N> s{.balls = balls, .planes = planes, .walls = walls};
        s.period = period;
        return s;
    }

  private:
    [[nodiscard]] bool is_free(const graze::ball<N>& b) const {
        for (const auto& other : balls) {
            double square = 0;
            for (int i = 0; i < N; ++i) {
                const double d = b.position[i] - other.position[i];
                const double apart = period[i] > 0 ? std::remainder(d, period[i]) : d;
                square += apart * apart;
            }
            if (std::sqrt(square) < b.radius + other.radius) {
                return false;
            }
        }
        for (const auto& w : walls) { // roughly: away from both ends and everything between
            for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                if (std::sqrt(graze::squared_norm(b.position - w.corner - s * w.edge[0])) < b.radius + 0.4) {
                    return false;
                }
            }
        }
        return true;
    }
};

struct comparison {
    std::uint64_t events = 0;
    int clocks = 0;      // how often a clock was set back
    int ties = 0;        // scenes that ended at two nearly simultaneous events
    std::string problem; // where the two differ; empty if nowhere
};

// Runs one scene for at most this many events.
template <int N>
void compare(std::uint64_t seed, int most, comparison& result) {
    mpf_set_default_prec(1024);
    std::mt19937_64 random(seed);
    const drawn_scene<N> drawn(random);
    simulator<N> expected(drawn.view());
    double end = 12;
    bool tie = false;
    const auto differ = [&](const std::string& what) {
        result.problem = "scene " + std::to_string(seed) + " in " + std::to_string(N) + " dimensions, event " +
                         std::to_string(result.events) + ": " + what;
        return false;
    };
    int done = 0;
    const auto finished =
        run_exactly<N>(drawn.view(), {.time = end, .events = static_cast<std::uint64_t>(most)},
                       [&](const exact_event<N>& e) {
                           bool is_clear = true;
                           const auto next = expected.next(end, is_clear);
                           tie = !is_clear;
                           if (tie) {
                               return false;
                           }
                           ++done;
                           ++result.events;
                           graze::scene_pair who = e.who;
                           if (who.with == graze::partner::ball && who.b < who.a) {
                               std::swap(who.a, who.b);
                           }
                           if (!next || next->who != who) {
                               return differ(to_string(who) + " is not next");
                           }
                           const auto same = [&](int ball, const graze::flight<N>& f) {
                               return expected[ball].since == f.since &&
                                      expected[ball].state.position == f.state.position &&
                                      expected[ball].state.velocity == f.state.velocity;
                           };
                           return (same(e.who.a, e.after_a) && (!e.after_b || same(e.who.b, *e.after_b))) ||
                                  differ(to_string(who) + " leave otherwise");
                       },
                       graze::cells::where_useful, {.by = 0.5, .events = 1, .told = [&] {
                                                        ++result.clocks;
                                                        expected.set_clock_back(0.5);
                                                        end -= 0.5;
                                                    }});
    result.ties += tie ? 1 : 0;
    bool is_clear = true;
    if (result.problem.empty() && !tie && done < most && expected.next(end, is_clear) && is_clear) {
        (void)differ("one is missed");
    }
}

} // namespace brute_force
