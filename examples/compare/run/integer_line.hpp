// Long rational flights without division: integers over one denominator. Head-on collisions, and bounces off planes
// across an axis, multiply them by factors.
#pragma once

#include <graze/linear/vec.hpp>

#include <gmpxx.h>

namespace compare::run {

// A ball that is at (place + speed t)/denominator at each time t from `since` on. Fractions may have common factors:
// looking for them would take longer than everything else. Denominators are positive.
template <int N>
struct integer_line {
    mpz_class denominator;
    graze::vec<N, mpz_class> place, speed;
    struct {
        mpz_class numerator, denominator;
    } since;
};

// Two balls that touch at the distance `reach`, after coming closer along an axis with all other coordinates equal:
// both lines after the contact. Masses are given by their inverses, not both 0. The contact keeps the line of the
// common centre. The whole lines change, not only the velocities: a's by 2 inverse_a/(inverse_a + inverse_b) times
// their separation less the reach. Returns false, and changes nothing, if the balls do not meet like that.
template <int N>
[[nodiscard]] bool bounce_head_on(integer_line<N>& a, integer_line<N>& b, const mpq_class& reach,
                                  const mpq_class& inverse_a, const mpq_class& inverse_b);

// The same for a ball of radius r that meets a plane across an axis.
template <int N>
[[nodiscard]] bool bounce_off(integer_line<N>& a, const mpq_class& r, const graze::vec<N, mpq_class>& point,
                              const graze::vec<N, mpq_class>& normal);

} // namespace compare::run
