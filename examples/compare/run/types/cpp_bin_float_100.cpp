#include "cpp_bin_float.hpp"

namespace compare::run::types {

runnable of_cpp_bin_float_100() { return of_digits<100>(); }

} // namespace compare::run::types
