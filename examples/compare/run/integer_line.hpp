// Long rational flights without a division: integers over one denominator, which head-on collisions and bounces off
// what stands across an axis change by factors alone.
#pragma once

#include <graze/linear/vec.hpp>

#include <gmpxx.h>

namespace compare::run {

// A ball that is at (place + speed t)/denominator at the time t, from since on. Every fraction may have common factors:
// to look for them would take longer than all else. Denominators are positive.
template <int N>
struct integer_line {
    mpz_class denominator;
    graze::vec<N, mpz_class> place, speed;
    struct {
        mpz_class numerator, denominator;
    } since;
};

// Two that touch at the distance `reach`, after they have come closer along an axis while no other coordinate tells
// them apart: both lines as they go on from there. With masses by their inverses, not both 0. The contact keeps the
// common centre's line, and the lines themselves, not only the velocities, change by the same factors: a's by 2
// inverse_a/(inverse_a + inverse_b) of what separates the two less the reach. False, and nothing changed, where they
// don't meet like that.
template <int N>
[[nodiscard]] bool bounce_head_on(integer_line<N>& a, integer_line<N>& b, const mpq_class& reach,
                                  const mpq_class& inverse_a, const mpq_class& inverse_b);

// One of radius r that meets a plane across an axis, likewise.
template <int N>
[[nodiscard]] bool bounce_off(integer_line<N>& a, const mpq_class& r, const graze::vec<N, mpq_class>& point,
                              const graze::vec<N, mpq_class>& normal);

} // namespace compare::run
