// Times of the certified run.
#pragma once

#include "certified.hpp"

#include <graze/formula/quadratic.hpp>

#include <functional>
#include <optional>

namespace compare::run {

// When things meet. Where it is no exact number but both were before, the quadratic whose smaller root it is too, in
// absolute time, so that ties are found exactly even between such times. Where it is open whether they meet, value is
// only not before the first instant at which they may: an interval without an upper end.
struct certified_time {
    using coefficients = graze::quadratic<certified, certified, certified>;
    certified value;
    std::function<coefficients()> exactly;
};

// The sign of s - t. Throws graze::undecided.
[[nodiscard]] int order_of(const certified_time& s, const certified_time& t);

// When two may meet of which it is open whether they do: not before their gap is closed at their speed, or, where q is
// given, not before its smaller root, if it has one. Throws undecided_sign if they may touch now.
[[nodiscard]] certified_time not_before(const certified& now, const certified& gap, const certified& speed,
                                        const std::optional<certified_time::coefficients>& q);

} // namespace compare::run
