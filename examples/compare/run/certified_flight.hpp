// A ball in flight in numbers of the certified run.
#pragma once

#include "certified.hpp"
#include "integer_line.hpp"

#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>

#include <memory>

namespace compare::run {

// line: the same exactly, where all its numbers are rational but so long that the flight itself has enclosures of them.
template <int N>
struct certified_flight : graze::flight<N, certified> {
    std::shared_ptr<const integer_line<N>> line{};
};

// A longer rational, numerator and denominator together, is not computed with but where nothing else will do.
inline constexpr std::size_t long_rational = 4096;

template <int N>
[[nodiscard]] bool is_exact(const certified_flight<N>& a); // or has a line

// With exact numbers in place of the line.
template <int N>
[[nodiscard]] certified_flight<N> exactly(const certified_flight<N>& a);

// With a line in place of long rationals.
template <int N>
void shorten(certified_flight<N>& a);

// bounce_head_on and bounce_off where both have a line, or one has and the other could: radii and masses rational.
template <int N>
[[nodiscard]] bool bounce_long(certified_flight<N>& a, certified_flight<N>& b);
template <int N>
[[nodiscard]] bool bounce_long(certified_flight<N>& a, const graze::plane<N, certified>& p);

} // namespace compare::run
