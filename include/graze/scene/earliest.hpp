// Of what a run has foreseen, that which is exactly the earliest.
#pragma once

#include <graze/scene/event_heap.hpp>
#include <graze/scene/moving_scene.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// An event that is next, with its exact time. chosen: it shares a ball with another event of exactly that time.
template <class Time>
struct due {
    foreseen what;
    Time when;
    bool chosen = false;
};

[[nodiscard]] constexpr bool is_of_same_bodies(const foreseen& x, const foreseen& y) noexcept {
    return x.a == y.a && x.b == y.b;
}

// Sorts what may be the earliest by bodies, which is the canonical order, and drops what was foreseen twice.
template <class Time>
void put_in_order(std::vector<due<Time>>& nearest) {
    if (nearest.size() < 2) {
        return;
    }
    using event = due<Time>;
    std::sort(nearest.begin(), nearest.end(), [](const event& x, const event& y) {
        return std::pair(x.what.a, x.what.b) < std::pair(y.what.a, y.what.b);
    });
    const auto is_same = [](const event& x, const event& y) { return is_of_same_bodies(x.what, y.what); };
    nearest.erase(std::unique(nearest.begin(), nearest.end(), is_same), nearest.end());
}

// Those of them that are the earliest, in the same order; their times are moved. Allocates only where there are more
// than ever before.
template <mechanics M>
void select_earliest(const moving_scene<M>& scene, std::vector<due<typename M::time>>& nearest,
                     std::vector<due<typename M::time>>& earliest) {
    earliest.clear();
    for (auto& d : nearest) {
        int order = 0;
        if (!earliest.empty()) {
            const foreseen& first = earliest.front().what;
            try {
                order = scene.rules().order(d.when, earliest.front().when);
            } catch (graze::undecided& e) {
                e.between(scene.named(d.what.a, d.what.b), scene.named(first.a, first.b));
                throw;
            }
        }
        if (order < 0) {
            earliest.clear();
        }
        if (order <= 0) {
            earliest.push_back(std::move(d));
        }
    }
}

} // namespace graze::inline v0_1::detail
