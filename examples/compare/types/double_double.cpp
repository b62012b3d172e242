#include "double_double.hpp"

#include "../measure.hpp"
#include "types.hpp"

namespace compare::types {

measurable of_double_double() {
    return measurable_type<dd_real>("QD", false, "an unevaluated sum of two doubles; the exponent range of double");
}

} // namespace compare::types
