#include "float128.hpp"

#include "../measure.hpp"
#include "types.hpp"

namespace compare::types {

measurable of_float128() { return measurable_type<__float128>("libquadmath"); }

} // namespace compare::types
