#include "runnable.hpp"

namespace compare::run {

// COMPARE_HAS_* are set by the build.
std::vector<runnable> all_runnables() {
    std::vector<runnable> list;
    list.push_back(types::of_graze());
    list.push_back(types::of_float());
    list.push_back(types::of_double());
    list.push_back(types::of_long_double());
#if COMPARE_HAS_QD
    list.push_back(types::of_double_double());
#endif
#if COMPARE_HAS_FLOAT128
    list.push_back(types::of_float128());
#endif
    list.push_back(types::of_cpp_bin_float_50());
    list.push_back(types::of_mpfr_float_50()); // MPFI rests on MPFR
    list.push_back(types::of_cpp_bin_float_100());
    return list;
}

} // namespace compare::run
