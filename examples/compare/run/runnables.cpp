#include "runnable.hpp"

namespace compare::run {

// The build sets COMPARE_HAS_*.
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
    list.push_back(types::of_mpfr_float_50()); // always there: the certified run needs MPFI, and MPFI needs MPFR
    list.push_back(types::of_cpp_bin_float_100());
    return list;
}

} // namespace compare::run
