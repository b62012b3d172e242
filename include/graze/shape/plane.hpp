// An infinite, two-sided plane (a line when N = 2).
#pragma once

#include <graze/linear/vec.hpp>

namespace graze::inline v0_1 {

// point: any point of the plane. normal: perpendicular to the plane, of any length but 0; either direction will do.
template <int N, class T = double>
struct plane {
    vec<N, T> point;
    vec<N, T> normal;
};

} // namespace graze::inline v0_1
