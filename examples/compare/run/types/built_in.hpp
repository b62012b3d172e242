// Runs in a floating-point type of the language.
#pragma once

#include "../type_run.hpp"

#include <graze/number/floating.hpp>
#include <graze/run/plain_mechanics.hpp>

namespace compare::run::types {

template <class T>
runnable built_in() {
    return {graze::number_traits<T>::name, "built in", run_type<graze::plain_mechanics<2, T>>,
            run_type<graze::plain_mechanics<3, T>>};
}

} // namespace compare::run::types
