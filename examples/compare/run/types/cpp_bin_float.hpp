// Runs in Boost's binary floating-point numbers.
#pragma once

#include "../../types/cpp_bin_float.hpp"

#include "../type_run.hpp"

#include <graze/run/plain_mechanics.hpp>

namespace compare::run::types {

template <unsigned Digits>
runnable of_digits() {
    using number = cpp_bin_float<Digits>;
    return {graze::number_traits<number>::name, "Boost", run_type<graze::plain_mechanics<2, number>>,
            run_type<graze::plain_mechanics<3, number>>};
}

} // namespace compare::run::types
