// Times of the certified run.
#pragma once

#include "certified.hpp"

#include <graze/formula/quadratic.hpp>

#include <functional>
#include <optional>

namespace compare::run {

// When two things meet. If the time is not exact but both flights were, `exactly` gives a quadratic whose smaller root
// it is, in absolute time: so even ties between such times are found exactly. If it is open whether they meet, value is
// not before the first instant at which they may: an interval without an upper end.
struct certified_time {
    using coefficients = graze::quadratic<certified, certified, certified>;
    certified value;
    std::function<coefficients()> exactly;
};

// The sign of s - t. Throws graze::undecided.
[[nodiscard]] int order_of(const certified_time& s, const certified_time& t);

// For two of which it is open whether they meet: a time not after the first at which they may. The gap cannot close
// faster than at their speed; if q is given, they also do not meet before its smaller root, if it has one. Throws
// undecided_sign if they may touch now.
[[nodiscard]] certified_time not_before(const certified& now, const certified& gap, const certified& speed,
                                        const std::optional<certified_time::coefficients>& q);

} // namespace compare::run
