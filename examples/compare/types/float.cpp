#include "../measure.hpp"
#include "types.hpp"

#include <graze/number/floating.hpp>

namespace compare::types {

measurable of_float() { return measurable_type<float>("built in"); }

} // namespace compare::types
