#include "built_in.hpp"

namespace compare::run::types {

runnable of_double() { return built_in<double>(); }

} // namespace compare::run::types
