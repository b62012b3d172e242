// The encounter of a ball with a flat, convex shape, and the feature that it meets: one procedure for every number
// type. It tries first the signs that decide most pairs.
//
// A ball that is not over the shape now meets it exactly if its centre's line passes it at less than r. The place where
// the line crosses the plane determines the one feature that is nearest to it: the face, an edge or a corner. That
// feature's h tells whether the ball comes closer at all, and its D whether it meets the shape.
#pragma once

#include <graze/formula/flat_entry.hpp>
#include <graze/formula/flat_hull.hpp>

namespace graze::inline v0_1 {

// Decides recede or miss for most pairs that are apart. Not certain if the edges may be parallel.
template <int N, class T, class Judge>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer from_afar(const flat_motion<N, T>& m,
                                                                         const Judge& judge) {
    const auto extent = extent_of(m);
    const auto edges = edges_of(m);
    if (judge(recedes_from_all{}, extent) == 1) {
        return {judge(edges_span{}, edges) == 1, encounter::recede};
    }
    if (judge(passes_beside{}, hull_of(m, edges)) == 1 && judge(recedes_from_any{}, extent) == -1) {
        return {judge(edges_span{}, edges) == 1, encounter::miss};
    }
    return {};
}

template <int N, class T, class Judge>
class flat_decision : public flat_entry<N, T, Judge> {
  public:
    using flat_entry<N, T, Judge>::flat_entry;

    // Only `what`; the feature means nothing.
    [[nodiscard, gnu::always_inline]] constexpr flat_answer what() const {
        const int speed = of_way(way_speed{});
        if (speed == open_sign) {
            return {};
        }
        if constexpr (sight::sees_zero) {
            if (speed == 0) {
                return from_place();
            }
        }
        const located near = nearest([&](int k) { return inside(k, speed); }, [&](int k) { return along_way(k); });
        if (near.where == none) {
            return {};
        }
        int d = 1;
        if (near.where == feature::face) {
            const int height = of_way(way_height{});
            if (height == open_sign) {
                return {};
            }
            if (height != -speed) {
                return {true, encounter::recede};
            }
        } else {
            const auto x = seen_from_feature(near);
            const int h = approach(near, x);
            d = discriminant(near, x);
            if (h == open_sign) {
                return {};
            }
            if (h >= 0) {
                return {true, encounter::recede};
            }
            if (d == open_sign) {
                return {};
            }
            if (d < 0) {
                return {true, encounter::miss};
            }
            if (d == 0) {
                return {true, encounter::graze, near.where, near.index};
            }
        }
        const int from_slab = clearance_of_plane();
        if (from_slab == 0 || from_slab == 1) {
            return {true, encounter::hit, none};
        }
        return from_clearance();
    }

    // The feature of a hit.
    [[nodiscard]] constexpr flat_answer with_feature(flat_answer found) const {
        return found.certain && found.what == encounter::hit && found.where == none ? entry() : found;
    }
    [[nodiscard]] constexpr flat_answer operator()() const { return with_feature(what()); }

  private:
    using sight = flat_sight<N, T, Judge>;
    using located = typename sight::located;
    using sight::along_way;
    using sight::approach;
    using sight::clearance_of;
    using sight::clearance_of_plane;
    using sight::discriminant;
    using sight::inside;
    using sight::nearest;
    using sight::nearest_now;
    using sight::none;
    using sight::of_way;
    using sight::seen_from_feature;
    using flat_entry<N, T, Judge>::entry;

    // For a ball that comes closer than r and is in the slab, or may be.
    [[nodiscard, gnu::noinline]] constexpr flat_answer from_clearance() const {
        const located now = nearest_now();
        const int c = clearance_of(now);
        return c == open_sign ? flat_answer{}
               : c < 0        ? flat_answer{true, encounter::overlap, now.where, now.index}
                              : flat_answer{true, encounter::hit, none};
    }
    // For a ball that moves parallel to the plane: its line has no single nearest feature.
    [[nodiscard, gnu::noinline]] constexpr flat_answer from_place() const {
        const located now = nearest_now();
        if (now.where == none) {
            return {};
        }
        if (now.where == feature::face) {
            return {true, encounter::recede};
        }
        const auto x = seen_from_feature(now);
        const int h = approach(now, x);
        if (h == open_sign) {
            return {};
        }
        if (h >= 0) {
            return {true, encounter::recede};
        }
        if (clearance_of_plane() == 1) {
            return {true, encounter::miss};
        }
        const int c = clearance_of(now);
        if (c == open_sign) {
            return {};
        }
        return c < 0 ? flat_answer{true, encounter::overlap, now.where, now.index} : entry();
    }
};

} // namespace graze::inline v0_1
