// The planes and walls that a point reaches at one time.
#pragma once

#include <graze/point/junction.hpp>
#include <graze/point/standing.hpp>
#include <graze/scene/records.hpp>

#include <optional>

namespace graze::inline v0_1::detail {

// Whether x moves in the plane of any plane or wall; true of walls that have images if it moves along them.
template <int N, class State, class X>
[[nodiscard]] bool slides(const standing_parts<N, State, X>& standing, const State& x) {
    for (body b = standing.begin(); b < standing.end(); ++b) {
        const standing_image s = standing.itself(b);
        if (standing.heading(s, x) == 0 && (standing.has_images(b) || standing.side(s, x) == 0)) {
            return true;
        }
    }
    return false;
}

// The planes and walls that x meets at exactly that instant, and those along which it then slides. meet(b): when it
// meets b. side_along(b): the side of b on which it stays while it moves in b's plane; 0 if that is not known.
template <int N, class State, class X, class Meet, class Side>
[[nodiscard]] junction<N, X> arrival(const standing_parts<N, State, X>& standing, const State& x, Meet meet,
                                     Side side_along) {
    struct touched {
        standing_image what;
        int side;
        approach way;
    };
    records<touched> all;
    std::optional<typename standing_parts<N, State, X>::place> apex;
    for (const standing_image& b : standing.near(standing.around_then(x))) {
        const meeting met = meet(b);
        const int heading = standing.heading(b, x);
        if (met == meeting::then) {
            if (heading == 0) {
                all.push_back({b, side_along(b), approach::to_border});
                continue;
            }
            all.push_back({b, -heading, approach::across});
            if (!apex) {
                apex = standing.crossing(b, x, x);
            }
        } else if (met == meeting::never && heading == 0 && standing.side(b, x) == 0) {
            all.push_back({b, side_along(b), approach::along});
        }
    }
    records<cone<N, X>> cones;
    for (const touched& c : all) {
        if (c.way != approach::along || (apex && standing.is_at(c.what, *apex))) {
            cones.push_back(standing.cone_at(c.what, c.side, c.way, apex));
        }
    }
    return {std::move(cones), standing.exactly(x.state.velocity)};
}

// A point that left b, was rounded to beyond it and comes back beside it, has been as near to b's border as rounding
// can tell. The planes and walls at that border; empty if the point comes back inside b. before: before it met b.
template <int N, class State, class X, class Side>
[[nodiscard]] std::optional<junction<N, X>> arrival_at_border(const standing_parts<N, State, X>& standing,
                                                              const State& before, const State& x,
                                                              const standing_image& b, Side side_along) {
    const auto back = standing.crossing(b, x, x);
    if (standing.is_inside(b, back)) {
        return std::nullopt;
    }
    const auto border = standing.nearest(b, back);
    records<cone<N, X>> cones;
    for (const standing_image& c : standing.near(standing.around(b))) {
        if (standing.is_in_plane(c, border) && standing.is_at(c, border)) {
            const int heading = standing.heading(c, before);
            cones.push_back(heading != 0 ? standing.cone_at(c, -heading, approach::across, border)
                                         : standing.cone_at(c, side_along(c), approach::along, border));
        }
    }
    return junction<N, X>(std::move(cones), standing.exactly(before.state.velocity));
}

} // namespace graze::inline v0_1::detail
