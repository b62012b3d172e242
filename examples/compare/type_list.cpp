#include "type_list.hpp"

#include "own_types.hpp"
#include "types/types.hpp"

#include <algorithm>

namespace compare {

// The build sets COMPARE_HAS_* for the libraries that it found. To add a type, add a source file in types/, a line in
// types.hpp and one in each list below. It need not be measured by graze::solve (see solver).

std::vector<measurable> all_types() {
    std::vector<measurable> list;
    list.push_back(types::of_graze());
    list.push_back(types::of_float());
    list.push_back(types::of_double());
    list.push_back(types::of_long_double());
#if COMPARE_HAS_FLOAT128
    list.push_back(types::of_float128());
#endif
#if COMPARE_HAS_QD
    list.push_back(types::of_double_double());
#endif
    list.push_back(types::of_fixed_point());
#if COMPARE_HAS_BOOST
    list.push_back(types::of_cpp_bin_float_50());
    list.push_back(types::of_cpp_bin_float_100());
    list.push_back(types::of_cpp_dec_float_50());
#endif
#if COMPARE_HAS_MPFR
    list.push_back(types::of_mpfr_float_50());
#endif
#if COMPARE_HAS_CGAL
    list.push_back(types::of_interval());
#endif
#if COMPARE_HAS_BOOST
    list.push_back(types::of_cpp_rational());
#endif
#if COMPARE_HAS_GMP && COMPARE_HAS_BOOST
    list.push_back(types::of_mpq_rational());
#endif
#if COMPARE_HAS_GMP
    list.push_back(types::of_mpq_class());
#endif
#if COMPARE_HAS_CGAL
    list.push_back(types::of_gmpq());
    list.push_back(types::of_exact_rational());
    list.push_back(types::of_lazy_exact());
    list.push_back(types::of_core_expr());
#endif
    for (measurable& own : own_types()) {
        const bool is_there = std::any_of(
            list.begin(), list.end(), [&](const measurable& m) { return m.information.name == own.information.name; });
        if (!is_there) {
            list.push_back(std::move(own));
        }
    }
    return list;
}

std::vector<missing_type> missing_types() {
    std::vector<missing_type> list;
#if COMPARE_ONLY_BUILT_IN
    return list; // nothing is missing: the others were left out on purpose
#endif
#if !COMPARE_HAS_FLOAT128
    list.push_back({"__float128", "the compiler has no quadmath.h"});
#endif
#if !COMPARE_HAS_QD
    list.push_back({"dd_real", "libqd was not found"});
#endif
#if !COMPARE_HAS_MPFR
    list.push_back({"mpfr_float_50", "MPFR was not found"});
#endif
#if !COMPARE_HAS_GMP
    list.push_back({"mpq_rational, mpq_class", "GMP was not found"});
#endif
#if !COMPARE_HAS_CGAL
    list.push_back({"CGAL::Interval_nt, CGAL::Gmpq, CGAL::Lazy_exact_nt, CORE::Expr", "CGAL was not found"});
#endif
    return list;
}

} // namespace compare
