#include "../type_run.hpp"

#include <graze/number/floating.hpp>
#include <graze/run/plain_mechanics.hpp>

namespace compare::run::types {

namespace {

template <class T>
runnable built_in() {
    return {graze::number_traits<T>::name, "built in", run_type<graze::plain_mechanics<2, T>>,
            run_type<graze::plain_mechanics<3, T>>};
}

} // namespace

runnable of_float() { return built_in<float>(); }
runnable of_double() { return built_in<double>(); }
runnable of_long_double() { return built_in<long double>(); }

} // namespace compare::run::types
