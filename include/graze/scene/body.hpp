// How a run numbers what it is of.
#pragma once

#include <cstdint>

namespace graze::inline v0_1::detail {

// A ball, plane or wall of a run: the balls first, then the planes, then the walls.
using body = std::uint32_t;
inline constexpr body no_body = 0xffffffffU;

// Body a, a ball, meets body b not before lower, unless one of the two has had another event since (counts).
struct foreseen {
    double lower;
    body a;
    body b;
    std::uint32_t count_a;
    std::uint32_t count_b;
};

} // namespace graze::inline v0_1::detail
