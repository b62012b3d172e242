// A ball in flight in numbers of the certified run.
#pragma once

#include "certified.hpp"
#include "integer_line.hpp"

#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>

#include <memory>

namespace compare::run {

// line: the same flight exactly, if its numbers are rational but too long; position, velocity and since then enclose
// it.
template <int N>
struct certified_flight : graze::flight<N, certified> {
    std::shared_ptr<const integer_line<N>> line{};
};

// A rational with more bits, numerator and denominator together, is computed with only where nothing else helps.
inline constexpr std::size_t long_rational = 4096;

template <int N>
[[nodiscard]] bool is_exact(const certified_flight<N>& a); // or has a line

// With its exact numbers instead of the line.
template <int N>
[[nodiscard]] certified_flight<N> exactly(const certified_flight<N>& a);

// Replaces long rationals by a line.
template <int N>
void shorten(certified_flight<N>& a);

// bounce_head_on and bounce_off, if one has a line and the other has or could have one: radii and masses are rational.
template <int N>
[[nodiscard]] bool bounce_long(certified_flight<N>& a, certified_flight<N>& b);
template <int N>
[[nodiscard]] bool bounce_long(certified_flight<N>& a, const graze::plane<N, certified>& p);

} // namespace compare::run
