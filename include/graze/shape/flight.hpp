// A ball in flight: straight on from an instant of its own.
#pragma once

#include <graze/shape/ball.hpp>

namespace graze::inline v0_1 {

// A ball that is at state.position at the time `since`, and at state.position + state.velocity (t - since) at a later
// time t. since: finite, of any sign, in the unit of time that lengths and velocities give.
template <int N, class T = double>
struct flight {
    ball<N, T> state;
    T since = T(0);
};

} // namespace graze::inline v0_1
