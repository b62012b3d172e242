// The earliest event of a scene, exactly.
#pragma once

#include <graze/scene/check_scene.hpp>
#include <graze/scene/first_search.hpp>
#include <graze/scene/image_pair.hpp>
#include <graze/scene/numbered_scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/time/bounds_of_image.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <optional>
#include <type_traits>
#include <vector>

namespace graze::inline v0_1 {

// The pairs that meet at that time, in an order that depends on the scene's numbers alone; of two balls, the one that
// comes first by its numbers is named first. Empty, as the time is, if nothing ever meets.
template <int N, class T = double>
struct earliest_events {
    std::optional<impact_time<N, T>> time;
    std::vector<scene_pair> events;
};

// All events at exactly the earliest time, or only the first of them in that order.
enum class simultaneous { all, first };

namespace detail {

template <int N, class T>
class earliest_finder {
  public:
    explicit earliest_finder(simultaneous wanted) : wanted_(wanted) {}

    void meet(const std::optional<impact_time<N, T>>& time, const scene_pair& who) {
        if (!time) {
            return;
        }
        const int order = found_.time ? time->compare(*found_.time) : -1;
        if (order < 0) {
            found_.time = time;
            found_.events.clear();
        }
        const bool is_new = found_.events.empty() || found_.events.back() != who; // not another image
        if (is_new && (order < 0 || (order == 0 && wanted_ == simultaneous::all))) {
            found_.events.push_back(who);
        }
    }
    [[nodiscard]] earliest_events<N, T> take() { return std::move(found_); }

  private:
    earliest_events<N, T> found_;
    simultaneous wanted_;
};

// When a ball meets something; a triangle is not met at an inner edge.
template <int N, class T, class S>
[[nodiscard]] std::optional<impact_time<N, T>> time_outside(const ball<N, T>& x, const S& other, unsigned inner) {
    if constexpr (N == 3 && std::is_same_v<S, triangle<T>>) {
        if (inner != 0 && is_inner(classify_feature(x, other), inner)) {
            return std::nullopt;
        }
    }
    return time_of_impact(x, other);
}

// An enclosure of the time at which they meet, as first_search asks for it.
template <int N, class T>
[[nodiscard]] enclosure bounds_of(const numbered_scene<N, T>& numbered, const vec<N, T>& period,
                                  const pair_of_bodies& pair, double latest) {
    enclosure found{enclosure::unknown, 0};
    numbered.with(pair.a, pair.b, [&](const ball<N, T>& x, const auto& y, const scene_pair&, unsigned inner) {
        if constexpr (std::is_same_v<decltype(y), const ball<N, T>&>) {
            const flight<N, T> a{x, T(0)}, b{y, T(0)};
            found = pair.image == image_index{} ? bounds_until(a, b, latest)
                                                : bounds_of_image(a, b, image_shift<N, T>{pair.image, period}, latest);
        } else {
            with_image(x, y, pair.image, period, [&](const auto& here, const auto& there) {
                if (const auto t = time_outside(here, there, inner)) {
                    found = t->enclosure();
                }
            });
        }
    });
    return found;
}

} // namespace detail

// The first of all collisions of balls with balls, planes, walls and triangles, by time_of_impact: exact for every
// finite input. Pairs that are not near each other are examined only while no earlier event is known. Two balls that
// overlap and approach meet at 0. In a scene that has a period they meet each other's images, and a pair that meets
// several of these at once is named once. Throws std::domain_error that names the part at fault ("ball 17: radius is
// negative") as check does, and for parallel edges ("ball 0 and wall 3: wall: edges are parallel"). With a period,
// throws std::range_error where a distance or an image is no number of T [exact_mechanics] and std::runtime_error where
// nothing meets for so long that nothing may ever.
template <int N, std::floating_point T>
requires is_binary_input<T>
[[nodiscard]] earliest_events<N, T> first_events(const scene<N, T>& s, simultaneous wanted = simultaneous::all) {
    check(s);
    detail::earliest_finder<N, T> earliest(wanted);
    const detail::numbered_scene<N, T> parts(s, detail::numbering::canonical);
    const auto bounds = [&](const detail::pair_of_bodies& pair, double latest) {
        return detail::bounds_of(parts, s.period, pair, latest);
    };
    detail::first_search<N, detail::numbered_scene<N, T>, decltype(bounds)> search(parts, bounds);
    for (const detail::pair_of_bodies& pair : search.find()) {
        parts.with(pair.a, pair.b, [&](const ball<N, T>& x, const auto& y, const scene_pair& who, unsigned inner) {
            detail::with_image(x, y, pair.image, s.period, [&](const auto& here, const auto& there) {
                earliest.meet(detail::time_outside(here, there, inner), who);
            });
        });
    }
    return earliest.take();
}

} // namespace graze::inline v0_1
