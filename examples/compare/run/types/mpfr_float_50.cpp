#include "../../types/mpfr_float_50.hpp"

#include "../type_run.hpp"

#include <graze/run/plain_mechanics.hpp>

namespace compare::run::types {

runnable of_mpfr_float_50() {
    return {"mpfr_float_50", "Boost on MPFR", run_type<graze::plain_mechanics<2, mpfr_float_50>>,
            run_type<graze::plain_mechanics<3, mpfr_float_50>>};
}

} // namespace compare::run::types
