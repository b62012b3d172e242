// A ball in flight: a ball and its epoch, from which on it flies straight.
#pragma once

#include <graze/shape/ball.hpp>

namespace graze::inline v0_1 {

// The ball is at state.position at its epoch, the time `since`, and at state.position + state.velocity (t - since) at
// every later time t. since: finite, of any sign, in the unit of length over that of velocity.
template <int N, class T = double>
struct flight {
    ball<N, T> state;
    T since = T(0);
};

} // namespace graze::inline v0_1
