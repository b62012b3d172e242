#include "../measure.hpp"
#include "types.hpp"

#include <graze/number/floating.hpp>

namespace compare::types {

measurable of_long_double() { return measurable_type<long double>("built in"); }

} // namespace compare::types
