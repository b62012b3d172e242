// The planes and walls that a point reaches at one time.
#pragma once

#include <graze/point/junction.hpp>
#include <graze/point/standing.hpp>
#include <graze/scene/records.hpp>

#include <optional>

namespace graze::inline v0_1::detail {

// Whether x moves in the plane of any plane or wall; true of walls that have images if it moves along them.
template <mechanics M>
[[nodiscard]] bool slides(const M& m, const standing_parts<M>& standing, const typename M::state& x) {
    for (body b = standing.begin(); b < standing.end(); ++b) {
        const standing_image s = standing.itself(b);
        if (standing.heading(m, s, x) == 0 && (standing.has_images(b) || standing.side(m, s, x) == 0)) {
            return true;
        }
    }
    return false;
}

// The planes and walls that x meets at exactly this time, and those along which it then slides. meet(b): when it meets
// b. side_along(b): the side of b on which it stays while it moves in b's plane; 0 if that is not known.
template <mechanics M, class Meet, class Side>
[[nodiscard]] junction<M::dimension, typename M::exact>
arrival(const M& m, const standing_parts<M>& standing, const typename M::state& x, const typename M::time& when,
        Meet meet, Side side_along) {
    struct touched {
        standing_image what;
        int side;
        approach way;
    };
    records<touched> all;
    std::optional<typename standing_parts<M>::place> apex;
    const double latest = m.bounds(when).upper;
    standing.for_each_near(m, standing.around(m, x, latest), [&](const standing_image& b) {
        const auto t = meet(b);
        const int heading = standing.heading(m, b, x);
        if (t && m.bounds(*t).lower <= latest && m.order(*t, when) == 0) {
            if (heading == 0) {
                all.push_back({b, side_along(b), approach::to_border});
                return;
            }
            all.push_back({b, -heading, approach::across});
            if (!apex) {
                apex = standing.crossing(m, b, x, x);
            }
        } else if (!t && heading == 0 && standing.side(m, b, x) == 0) {
            all.push_back({b, side_along(b), approach::along});
        }
    });
    records<cone<M::dimension, typename M::exact>> cones;
    for (const touched& c : all) {
        if (c.way != approach::along || (apex && standing.is_at(m, c.what, *apex))) {
            cones.push_back(standing.cone_at(m, c.what, c.side, c.way, apex));
        }
    }
    return {std::move(cones), standing.exactly(m, x.state.velocity)};
}

// A point that left b, was rounded to beyond it and comes back beside it, has been as near to b's border as rounding
// can tell. The planes and walls at that border; empty if the point comes back inside b. before: before it met b.
template <mechanics M, class Side>
[[nodiscard]] std::optional<junction<M::dimension, typename M::exact>>
arrival_at_border(const M& m, const standing_parts<M>& standing, const typename M::state& before,
                  const typename M::state& x, const standing_image& b, Side side_along) {
    const auto back = standing.crossing(m, b, x, x);
    if (standing.is_inside(m, b, back)) {
        return std::nullopt;
    }
    const auto border = standing.nearest(m, b, back);
    records<cone<M::dimension, typename M::exact>> cones;
    standing.for_each_near(m, standing.around(m, b), [&](const standing_image& c) {
        if (standing.is_in_plane(m, c, border) && standing.is_at(m, c, border)) {
            const int heading = standing.heading(m, c, before);
            cones.push_back(heading != 0 ? standing.cone_at(m, c, -heading, approach::across, border)
                                         : standing.cone_at(m, c, side_along(c), approach::along, border));
        }
    });
    return junction<M::dimension, typename M::exact>(std::move(cones), standing.exactly(m, before.state.velocity));
}

} // namespace graze::inline v0_1::detail
