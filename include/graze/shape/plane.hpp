// An infinite, two-sided plane (a line when N = 2).
#pragma once

#include <graze/linear/vec.hpp>

namespace graze::inline v0_1 {

// point: any point of the plane. normal: perpendicular to it, of any length but 0; its sense has no meaning.
template <int N, class T = double>
struct plane {
    vec<N, T> point;
    vec<N, T> normal;
};

} // namespace graze::inline v0_1
