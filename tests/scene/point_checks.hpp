// The run of a point, compared with an oracle in rationals and with small balls beside it.
#pragma once

#include "exact_runs.hpp"
#include "point_oracle.hpp"
#include "point_scenes.hpp"

#include <cmath>
#include <string>
#include <utility>

struct told_bounce {
    std::size_t wall;
    graze::vec<3, double> velocity;
    double time;
    bool turned; // whether it was not a graze
};

template <int N>
[[nodiscard]] std::vector<told_bounce> bounces_of(const point_scene<N>& s, std::size_t most) {
    std::vector<told_bounce> told;
    (void)run_exactly<N>({s.point, {}, s.walls}, {.events = most}, [&](const exact_event<N>& e) {
        graze::vec<3, double> u{};
        for (int i = 0; i < N; ++i) {
            u[i] = e.after_a.state.velocity[i];
        }
        told.push_back({static_cast<std::size_t>(e.who.b), u, e.after_a.since,
                        e.after_a.state.velocity != e.before_a.state.velocity});
        return true;
    });
    return told;
}

template <int N>
[[nodiscard]] bool is_exact(const point_oracle::vector<N>& x) {
    return std::ranges::all_of(x, [](const mpq_class& c) { return mpq_class(c.get_d()) == c; });
}

// What is wrong with the reported events of a run of at most this many events, as long as all states are doubles; empty
// if nothing is. fineness: of the shifts in space.
template <int N>
[[nodiscard]] std::string fault_by_oracle(const point_scene<N>& s, const std::vector<told_bounce>& told,
                                          std::size_t most, std::size_t* compared, int fineness) {
    using namespace point_oracle;
    const walls_around<N> walls(s.walls);
    auto x = exactly(s.point[0].position), u = exactly(s.point[0].velocity);
    mpq_class now = 0;
    std::size_t next = 0; // the next of the reported events
    const auto is_told = [&](std::size_t wall) {
        return next < told.size() && told[next].wall == wall && told[next].time == now.get_d();
    };
    std::vector<std::pair<std::size_t, int>>
        kept; // sides of the walls along which the point has been sliding since its last event
    const auto side_along = [&](std::size_t wall) {
        int result = 0;
        for (const auto& [other, side] : kept) {
            result = result != 0 ? result : side * walls.common_sense(other, wall);
        }
        return sgn(dot<N>(u, walls[wall].normal)) == 0 ? result : 0;
    };
    const auto keep = [&](const std::vector<std::size_t>& touching, const auto& side_of) {
        std::vector<std::pair<std::size_t, int>> now_kept;
        for (std::size_t i = 0; i < touching.size(); ++i) {
            now_kept.emplace_back(touching[i], side_of(i));
        }
        kept = std::move(now_kept);
    };
    while (next < most) {
        mpq_class when = 0;
        auto here = walls.first(x, u, when);
        if (here.empty()) {
            return next == told.size() ? "" : "more than there is, at event " + std::to_string(next);
        }
        x = moved<N>(x, when, u);
        now += when;
        if (!is_exact<N>(x) || mpq_class(now.get_d()) != now) {
            return "";
        }
        const auto touching = walls.at(x);
        bool turned = false;
        while (!here.empty() && !turned) {
            // First the wall that the point can reach when shifted into it, if possible from the side of the others
            // from which it comes; then where such shifts lead.
            std::vector<passage> allowed;
            std::optional<touch> met;
            for (const touch& h : here) {
                if (h.graze) {
                    met = h;
                    break;
                }
                // Best: it comes from the side of the others from which it did, and leaves what it slid along.
                std::array<std::vector<passage>, 4> by_rank;
                for (const auto& shift : shifts_into<N>(walls[h.wall], x, fineness)) {
                    auto way = walls.bounces(x, shift, u, touching, h.wall);
                    if (way.bounces.empty() || way.bounces.front() != h.wall) {
                        continue;
                    }
                    const auto after = walls[h.wall].reflected(u);
                    bool leaves = true, on_side = true, kept_to = true;
                    for (const std::size_t other : touching) {
                        const auto& n = walls[other].normal;
                        const int came = sgn(dot<N>(u, n)), side = sgn(dot<N>(shift, n)), known = side_along(other);
                        on_side = on_side && side * came <= 0;
                        leaves = leaves && (came != 0 || known != 0 || side * sgn(dot<N>(after, n)) >= 0);
                        kept_to = kept_to && (known == 0 || side == known);
                    }
                    if (kept_to) {
                        by_rank[(on_side ? 0 : 2) + (leaves ? 0 : 1)].push_back(std::move(way));
                    }
                }
                for (const auto& ways : by_rank) {
                    allowed = allowed.empty() ? ways : allowed;
                }
                if (!allowed.empty()) {
                    met = h;
                    break;
                }
            }
            if (!met) {
                if (std::ranges::all_of(touching, [&](std::size_t wall) { return side_along(wall) == 0; })) {
                    return "the oracle finds no first wall";
                }
                break; // all are on the other side of what it slides along
            }
            if (met->graze) {
                if (next >= most) {
                    return "";
                }
                if (!is_told(met->wall) || told[next].turned) {
                    return "no graze of wall " + std::to_string(met->wall) + " at event " + std::to_string(next);
                }
                ++next;
                std::erase_if(here, [&](const touch& h) { return h.wall == met->wall; });
                keep(touching, [&](std::size_t i) { return side_along(touching[i]); });
                continue;
            }
            turned = true;
            const auto matches = [&](const passage& way) { // as far as velocities are not rounded
                auto v = u;
                for (std::size_t i = 0; i < way.bounces.size() && next + i < most; ++i) {
                    if (next + i >= told.size() || told[next + i].wall != way.bounces[i] ||
                        told[next + i].time != now.get_d()) {
                        return false;
                    }
                    v = walls[way.bounces[i]].reflected(v);
                    if (!is_exact<N>(v)) {
                        return true;
                    }
                }
                const std::size_t end = next + way.bounces.size();
                return end >= told.size() || told[end].time != now.get_d();
            };
            const auto found = std::ranges::find_if(allowed, matches);
            if (found == allowed.end()) {
                std::string text =
                    "otherwise at event " + std::to_string(next) + ", t = " + std::to_string(now.get_d()) + ", right:";
                for (const std::size_t w : allowed.front().bounces) {
                    text += " " + std::to_string(w);
                }
                return text;
            }
            for (const std::size_t w : found->bounces) {
                u = walls[w].reflected(u);
                if (next >= most) {
                    return "";
                }
                for (int i = 0; i < N; ++i) {
                    if (mpq_class(told[next].velocity[i]) != u[static_cast<std::size_t>(i)]) {
                        return is_exact<N>(u) ? "another velocity after event " + std::to_string(next) : "";
                    }
                }
                ++next;
                if (compared != nullptr) {
                    ++*compared;
                }
                if (!is_exact<N>(u)) {
                    return "";
                }
            }
            for (const passage& way : allowed) {
                if (way.bounces == found->bounces && way.side != found->side) {
                    return ""; // both are right and continue differently
                }
            }
            keep(touching, [&](std::size_t i) { return found->side[i]; });
        }
    }
    return "";
}

// The same and, if that matters, again with shifts so fine that they miss no way between walls of a grid.
template <int N>
[[nodiscard]] std::string fault_by_oracle(const point_scene<N>& s, const std::vector<told_bounce>& told,
                                          std::size_t most, std::size_t* compared) {
    const std::string fault = fault_by_oracle<N>(s, told, most, compared, 6);
    return fault.empty() || N == 2 ? fault : fault_by_oracle<N>(s, told, most, nullptr, 400);
}
template <int N>
[[nodiscard]] std::string fault_by_oracle(const point_scene<N>& s, std::size_t most, std::size_t* compared) {
    return fault_by_oracle<N>(s, bounces_of<N>(s, most), most, compared);
}

// The same by balls of radius 2^-24 that fly 2^-18 beside the point, as long as they meet the same things.
template <int N>
[[nodiscard]] std::string fault_beside_balls(const point_scene<N>& s, std::size_t most, std::size_t* compared,
                                             int directions) {
    const auto u = s.point[0].velocity;
    std::vector<graze::vec<N, double>> across;
    if constexpr (N == 2) {
        static_cast<void>(directions);
        across = {{{-u[1], u[0]}}, {{u[1], -u[0]}}};
    } else {
        const auto one = graze::cross(u, graze::vec<3, double>{{u[1] + 2, u[2] - 7, u[0] + 19}});
        const auto two = graze::cross(u, one);
        for (int i = 0; i < directions; ++i) {
            const double angle = i * 6.283 / directions;
            across.push_back(std::cos(angle) * one + (std::sin(angle) / std::sqrt(graze::squared_norm(u))) * two);
        }
    }
    std::vector<std::vector<std::size_t>> beside;
    for (const auto& d : across) {
        point_scene<N> shifted = s;
        shifted.point[0].radius = 0x1p-24;
        shifted.point[0].position = shifted.point[0].position + (0x1p-18 / std::sqrt(graze::squared_norm(d))) * d;
        std::vector<std::size_t> met;
        for (const auto& b : bounces_of<N>(shifted, most)) {
            met.push_back(b.wall);
        }
        beside.push_back(std::move(met));
    }
    std::size_t alike = beside[0].size();
    bool all = true;
    for (const auto& b : beside) {
        const auto [x, y] = std::ranges::mismatch(beside[0], b);
        alike = std::min(alike, static_cast<std::size_t>(x - beside[0].begin()));
        all = all && b.size() == beside[0].size();
    }
    all = all && alike == beside[0].size() && alike < most;
    std::vector<std::size_t> met;
    for (const auto& b : bounces_of<N>(s, 20 * most)) {
        if (b.turned) {
            met.push_back(b.wall);
        }
    }
    for (std::size_t i = 0; i < alike; ++i) {
        if (i >= met.size() || met[i] != beside[0][i]) {
            return "otherwise at bounce " + std::to_string(i);
        }
    }
    if (compared != nullptr) {
        *compared += alike;
    }
    return all && met.size() > alike ? "more than the balls beside it" : "";
}
template <int N>
[[nodiscard]] std::string fault_beside_balls(const point_scene<N>& s, std::size_t most, std::size_t* compared) {
    const std::string fault = fault_beside_balls<N>(s, most, compared, 16);
    return fault.empty() || N == 2 ? fault : fault_beside_balls<N>(s, most, nullptr, 1000);
}
