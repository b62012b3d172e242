// The exactly earliest of the events that a run has predicted.
#pragma once

#include <graze/run/moving_scene.hpp>
#include <graze/scene/canonical_order.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace graze::inline v0_1::detail {

// An event that is next, with its exact time. chosen: it shares a ball with another event of exactly that time.
template <class Time>
struct timed_event {
    predicted what;
    Time when;
    bool chosen = false;
};

[[nodiscard]] constexpr bool is_of_same_bodies(const predicted& x, const predicted& y) noexcept {
    return x.a == y.a && x.b == y.b && x.image == y.image;
}

[[nodiscard]] inline bool comes_before(const predicted& x, const predicted& y) noexcept {
    return std::tie(x.a, x.b, x.image) < std::tie(y.a, y.b, y.image);
}

// Sorts many events by bodies.
template <class Events>
void put_many_in_order(Events& nearest) {
    const auto order = sorted_indices(nearest.size(), &nearest, [](const void* events, int i, int j) {
        const Events& all = *static_cast<const Events*>(events);
        return comes_before(all[static_cast<std::size_t>(i)].what, all[static_cast<std::size_t>(j)].what);
    });
    Events sorted;
    sorted.reserve(nearest.size());
    for (const int i : order) {
        sorted.push_back(nearest[static_cast<std::size_t>(i)]);
    }
    nearest = std::move(sorted);
}

// Sorts the candidates by bodies, which is the canonical order, and drops duplicates. Allocates only where there are
// many.
template <class Events>
void put_in_order(Events& nearest) {
    const std::size_t n = nearest.size();
    std::size_t first = 1; // that is out of order
    while (first < n && comes_before(nearest[first - 1].what, nearest[first].what)) {
        ++first;
    }
    if (first >= n) {
        return;
    }
    if (n > 32) {
        put_many_in_order(nearest);
    } else {
        for (std::size_t i = first; i < n; ++i) {
            for (std::size_t j = i; j > 0 && comes_before(nearest[j].what, nearest[j - 1].what); --j) {
                std::swap(nearest[j], nearest[j - 1]);
            }
        }
    }
    std::size_t kept = 1;
    for (std::size_t i = 1; i < n; ++i) {
        if (!is_of_same_bodies(nearest[i].what, nearest[kept - 1].what)) {
            nearest[kept++] = nearest[i];
        }
    }
    nearest.erase(nearest.begin() + static_cast<std::ptrdiff_t>(kept), nearest.end());
}

// Whether the two events share a ball. A shared mirror does not count: nothing changes it.
template <mechanics M>
[[nodiscard]] bool share_a_ball(const moving_scene<M>& scene, const predicted& x, const predicted& y) noexcept {
    const auto is_shared = [&](body a) { return a < scene.balls() && !scene[a].immovable && (a == y.a || a == y.b); };
    return is_shared(x.a) || is_shared(x.b);
}

// For a mechanics that cannot order all of them: takes an event that certainly no other precedes, and those that are
// certainly simultaneous with it. An event that may be earlier but shares no ball with it can be done later. Throws M's
// undecided where the order matters, or where it is open whether two meet.
template <mechanics M>
void select_earliest_known(const moving_scene<M>& scene, const records<timed_event<typename M::time>>& nearest,
                           records<timed_event<typename M::time>>& earliest) {
    const auto is_open = [&](std::size_t i) { return std::isinf(scene.rules().bounds(nearest[i].when).upper); };
    const auto order = [&](std::size_t i, std::size_t j, bool matters) -> std::optional<int> {
        try {
            return i == j ? 0 : scene.rules().order(nearest[i].when, nearest[j].when);
        } catch (graze::undecided& e) {
            const predicted &x = nearest[i].what, &y = nearest[j].what;
            for (const std::size_t k : {i, j}) {
                if (matters && is_open(k)) {
                    graze::undecided unsettled("whether they meet", scene.rules().bounds(nearest[k].when).lower);
                    unsettled.between(scene.named(nearest[k].what.a, nearest[k].what.b));
                    throw unsettled;
                }
            }
            if (matters && share_a_ball(scene, x, y)) {
                e.between(scene.named(x.a, x.b), scene.named(y.a, y.b));
                throw;
            }
            return {};
        }
    };
    std::size_t first = 0;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        if (order(i, first, false).value_or(0) < 0) {
            first = std::exchange(i, std::size_t(-1)); // and once more from the start
        }
    }
    earliest.clear();
    bool certain = true;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        const std::optional<int> known = order(i, first, true);
        certain = certain && known;
        if (known == 0) {
            earliest.push_back(nearest[i]);
        }
    }
    if (!certain) { // others of its time may share a ball with an event that waits, so they wait too
        const predicted& one = nearest[first].what;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < earliest.size(); ++i) {
            if (is_of_same_bodies(earliest[i].what, one) || share_a_ball(scene, earliest[i].what, one)) {
                earliest[kept++] = earliest[i];
            }
        }
        earliest.erase(earliest.begin() + static_cast<std::ptrdiff_t>(kept), earliest.end());
    }
}

// The earliest of them, in the same order. Allocates only where there are more than ever before.
template <mechanics M>
void select_earliest(const moving_scene<M>& scene, const records<timed_event<typename M::time>>& nearest,
                     records<timed_event<typename M::time>>& earliest) {
    earliest.clear();
    try {
        for (const auto& d : nearest) {
            const int order = earliest.empty() ? 0 : scene.rules().order(d.when, earliest.front().when);
            if (order < 0) {
                earliest.clear();
            }
            if (order <= 0) {
                earliest.push_back(d);
            }
        }
    } catch (const graze::undecided&) {
        select_earliest_known(scene, nearest, earliest);
    }
}

// Among the planes and walls that a point will meet at one time, puts the one first that it meets first.
template <mechanics M>
void put_first_standing_first(const moving_scene<M>& scene, records<timed_event<typename M::time>>& events) {
    const auto is_standing = [&](const auto& d) { return d.what.b >= scene.balls(); };
    for (auto first = events.begin(); first != events.end();) {
        const auto of_same = [&](const auto& d) { return d.what.a == first->what.a; };
        const auto last = std::find_if_not(first, events.end(), of_same);
        const auto standing = std::find_if(first, last, is_standing);
        if (last - standing > 1) {
            const standing_image met = scene.first_standing(first->what.a, first->when);
            const auto leads = [&](const auto& d) { return standing_image{d.what.b, d.what.image} == met; };
            if (const auto chosen = std::find_if(standing, last, leads); chosen != last) {
                std::rotate(standing, chosen, std::next(chosen));
            }
        }
        first = last;
    }
}

} // namespace graze::inline v0_1::detail
