#include "built_in.hpp"

namespace compare::run::types {

runnable of_long_double() { return built_in<long double>(); }

} // namespace compare::run::types
