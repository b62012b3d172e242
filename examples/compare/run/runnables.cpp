#include "runnable.hpp"

namespace compare::run {

// COMPARE_HAS_* and COMPARE_FEW_RUN_TYPES are set by the build.
std::vector<runnable> all_runnables() {
    std::vector<runnable> list;
#if !COMPARE_FEW_RUN_TYPES
    list.push_back(types::of_graze());
    list.push_back(types::of_float());
#endif
    list.push_back(types::of_double());
#if !COMPARE_FEW_RUN_TYPES
    list.push_back(types::of_long_double());
#endif
#if COMPARE_HAS_QD
    list.push_back(types::of_double_double());
#endif
#if COMPARE_HAS_FLOAT128
    list.push_back(types::of_float128());
#endif
    list.push_back(types::of_cpp_bin_float_50());
#if !COMPARE_FEW_RUN_TYPES
    list.push_back(types::of_mpfr_float_50()); // MPFI rests on MPFR
    list.push_back(types::of_cpp_bin_float_100());
#endif
    return list;
}

} // namespace compare::run
