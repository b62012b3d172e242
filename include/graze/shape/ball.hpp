// A ball: a disc in the plane, a sphere in space.
#pragma once

#include <graze/linear/vec.hpp>

namespace graze::inline v0_1 {

// position, velocity: those of the centre at t = 0, in any consistent units. radius >= 0; 0 is a point. mass > 0 in any
// unit, or infinite for a ball whose velocity never changes.
template <int N, class T = double>
struct ball {
    vec<N, T> position;
    vec<N, T> velocity;
    T radius;
    T mass = T(1);
};

} // namespace graze::inline v0_1
