#include "cpp_bin_float.hpp"

namespace compare::run::types {

runnable of_cpp_bin_float_50() { return of_digits<50>(); }

} // namespace compare::run::types
