// Runs in exact mechanics of doubles and in plain doubles: graze::compiled contains them, so that a unit need not
// compile them.
#pragma once

#include <graze/run/exact_mechanics.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>

namespace graze::inline v0_1 {

extern template class run<exact_mechanics<2, double>>;
extern template class run<exact_mechanics<3, double>>;
extern template class run<plain_mechanics<2, double>>;
extern template class run<plain_mechanics<3, double>>;

} // namespace graze::inline v0_1
