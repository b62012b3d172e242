#include "../measure.hpp"
#include "types.hpp"

#include <graze/number/adapter/float128.hpp>

namespace compare::types {

measurable of_float128() { return measurable_type<__float128>("libquadmath"); }

} // namespace compare::types
