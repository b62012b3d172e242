// How hard a pair is in itself, for any computation.
#pragma once

#include "truth.hpp"

namespace compare {

// Sets t's condition numbers, from its exact time, by implicit differentiation of the equation that the time solves.
template <int N>
void set_conditions(truth& t, const problem<N>& pair);

} // namespace compare
