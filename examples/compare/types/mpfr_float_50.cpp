#include "mpfr_float_50.hpp"

#include "../measure.hpp"
#include "types.hpp"

namespace compare::types {

measurable of_mpfr_float_50() { return measurable_type<mpfr_float_50>("Boost on MPFR", true); }

} // namespace compare::types
