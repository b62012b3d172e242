// The sides of planes and walls on which a point belongs, where the rounding of its position has lost them.
#pragma once

#include <graze/point/standing.hpp>

namespace graze::inline v0_1::detail {

// Whether x is on b, or on the side of b on which it does not belong.
template <int N, class State, class X>
[[nodiscard]] bool is_beyond(const standing_parts<N, State, X>& standing, const standing_image& b, const State& x,
                             int side) {
    return standing.side(b, x) * side <= 0;
}

// A point was at `before`, on the kept side of b, met `met` or a ball at that instant, and became x. The side of b on
// which it belongs; 0 where it is on that side, or has come past b.
template <int N, class State, class X>
[[nodiscard]] int side_lost(const standing_parts<N, State, X>& standing, const State& before, const State& x,
                            const standing_image& met, const standing_image& b, int kept) {
    const int heading = standing.heading(b, before);
    if (!standing.rounds()) { // it is where it was, if it has slid along b
        return kept != 0 && heading == 0 && standing.side(b, x) == 0 && standing.is_at(b, standing.crossing(b, x, x))
                   ? kept
                   : 0;
    }
    int side = kept != 0 ? kept : standing.side(b, before);
    side = side != 0 ? side : heading != 0 ? heading : standing.heading(b, x); // where it slid along b
    if (side == 0 || standing.side(b, x) == side) {
        return 0;
    }
    if (side * heading < 0 && !(kept != 0 && is_beyond(standing, b, before, kept))) { // it was coming nearer
        const int passed = standing.after_reaching(b, before);
        side = passed > 0 ? -side : passed < 0 ? side : 0; // beside b, whose plane it may just have reached
    }
    if (side == 0 || standing.side(b, x) == side) {
        return 0;
    }
    // Where it comes back to b's plane from where it really met `met`, else where it has passed that plane.
    const bool comes_back = met.is_any() && standing.heading(b, x) * side < 0;
    const auto place =
        comes_back ? standing.crossing(b, standing.crossing(met, before, before), x) : standing.crossing(b, x, before);
    return standing.is_at(b, place) ? side : 0;
}

} // namespace graze::inline v0_1::detail
