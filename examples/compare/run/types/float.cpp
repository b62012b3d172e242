#include "built_in.hpp"

namespace compare::run::types {

runnable of_float() { return built_in<float>(); }

} // namespace compare::run::types
