#include "../measure.hpp"
#include "cpp_bin_float.hpp"
#include "types.hpp"

namespace compare::types {

measurable of_cpp_bin_float_50() { return measurable_type<cpp_bin_float<50>>("Boost"); }

} // namespace compare::types
