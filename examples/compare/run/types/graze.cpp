#include "../type_run.hpp"

#include <graze/run/exact_mechanics.hpp>

namespace compare::run::types {

runnable of_graze() {
    return {"graze", "graze", run_type<graze::exact_mechanics<2, double>>, run_type<graze::exact_mechanics<3, double>>};
}

} // namespace compare::run::types
