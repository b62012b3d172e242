// The earliest event of all balls, found among neighbours.
#pragma once

#include <graze/scene/remaining_pairs.hpp>
#include <graze/scene/surroundings.hpp>
#include <graze/time/enclosure.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// All pairs of a ball and another body, the smaller number first for two balls, that may happen first of all, from t =
// 0 on, in the order of their numbers. bounds(a, b, latest): an enclosure of the time at which
// they meet, from the largest double on if they don't or if it is certainly later than `latest`.
//
// If a ball meets another body before its shell ends, one of the two is on the other's list. So all shells that end
// before the earliest time known are renewed, at their ends, until there is none.
template <int N, class F>
[[nodiscard]] std::vector<std::pair<body, body>> may_be_first(const std::vector<flight<N, double>>& balls,
                                                              standing_cells<N> standing, body bodies, F bounds) {
    struct candidate {
        double lower;
        body a, b;
    };
    constexpr double never = std::numeric_limits<double>::max();
    const auto count = static_cast<body>(balls.size());
    std::vector<candidate> found;
    double latest = never;
    const auto offer = [&](body a, body b) {
        const auto [x, y] = std::minmax(a, b);
        const enclosure t = bounds(x, y, latest);
        if (t.lower() < never && t.lower() <= latest) {
            found.push_back({t.lower(), x, y});
            latest = std::min(latest, t.upper());
        }
    };
    surroundings<N> around(balls, 0, std::move(standing), true);
    std::vector<std::pair<double, body>> ends; // a heap
    const auto is_later = [](const auto& x, const auto& y) { return x.first > y.first; };
    const auto note_end = [&](body a, double now) {
        const auto end = around.end(a, balls[a], now);
        ends.emplace_back(end.known ? end.when : now, a);
        std::push_heap(ends.begin(), ends.end(), is_later);
    };
    const auto offer_all = [&](body a) {
        for (body b = 0; b < bodies; ++b) {
            if (b != a) {
                offer(a, b);
            }
        }
    };
    for (body a = 0; a < count; ++a) {
        if (around.is_everywhere(a)) {
            offer_all(a);
            continue;
        }
        for (const body b : around.of(a)) {
            if (b > a) {
                offer(a, b);
            }
        }
        note_end(a, 0);
    }
    remaining_pairs<N> remaining;
    const auto is_alike = [](body, body) { return true; }; // the doubles are exact
    const auto offer_remaining = [&](body a) {
        if (!remaining.knows(a)) {
            offer_all(a);
            return;
        }
        remaining.for_each(a, is_alike, [&](body b) { offer(a, b); });
        for (body b = count; b < bodies; ++b) {
            offer(a, b);
        }
    };
    while (!ends.empty() && ends.front().first <= latest && ends.front().first < never) {
        const auto [now, a] = ends.front();
        std::pop_heap(ends.begin(), ends.end(), is_later);
        ends.pop_back();
        if (!remaining.is_known() && around.idle().has_waited() &&
            !remaining.find(balls, now, around.idle().affordable_pairs(), is_alike)) {
            around.idle().wait_longer();
        }
        if (remaining.is_known()) {
            around.spread(a);
            offer_remaining(a);
        } else if (around.look_around(a, balls[a], now)) {
            around.make_room(a);
            around.settle(a);
            for (const body b : around.of(a)) {
                offer(a, b);
            }
            note_end(a, now);
        } else {
            around.spread(a);
            offer_all(a);
        }
    }
    std::erase_if(found, [&](const candidate& c) { return c.lower > latest; });
    std::vector<std::pair<body, body>> pairs;
    for (const candidate& c : found) {
        pairs.emplace_back(c.a, c.b);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

} // namespace graze::inline v0_1::detail
