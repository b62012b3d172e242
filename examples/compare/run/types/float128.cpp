#include "../type_run.hpp"

#include <graze/number/adapter/float128.hpp>
#include <graze/run/plain_mechanics.hpp>

namespace compare::run::types {

runnable of_float128() {
    return {"__float128", "libquadmath", run_type<graze::plain_mechanics<2, __float128>>,
            run_type<graze::plain_mechanics<3, __float128>>};
}

} // namespace compare::run::types
