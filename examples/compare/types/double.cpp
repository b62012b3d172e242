#include "../measure.hpp"
#include "types.hpp"

#include <graze/number/floating.hpp>

namespace compare::types {

measurable of_double() { return measurable_type<double>("built in"); }

} // namespace compare::types
