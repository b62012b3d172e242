#include "inexact.hpp"

#include <graze/number/adapter/qd.hpp>

namespace inexact {

// Hida, Li, Bailey, Algorithms for Quad-Double Precision Floating Point Arithmetic (2000), and Joldes, Muller, Popescu
// (2017): with u = 2^-53 a product errs by 5 to 7 u², a quotient by at most 15 u², a root by a few; QD's default sum is
// the fast one, whose error is small beside the operands only. 16 u² bounds them all.
template <>
struct rounding<dd_real> {
    static double unit() { return 0x1p-102; }
    static constexpr bool sums_by_operands = true;
};
// For quad-doubles the first paper gives 2^-209 for a product and 2^-212 for an accurate sum. Roots and quotients err
// by a few times these.
template <>
struct rounding<qd_real> {
    static double unit() { return 0x1p-205; }
    static constexpr bool sums_by_operands = true;
};

template <>
struct to<dd_real> {
    static dd_real convert(double x) { return dd_real(x); }
};
template <>
double magnitude(const dd_real& x) {
    return up(std::abs(x.x[0]));
}
template <>
double magnitude(const qd_real& x) {
    return up(std::abs(x.x[0]));
}
template <>
mpq_class exact_value(dd_real x) {
    return mpq_class(x.x[0]) + mpq_class(x.x[1]);
}
template <>
mpq_class exact_value(qd_real x) {
    return mpq_class(x.x[0]) + mpq_class(x.x[1]) + mpq_class(x.x[2]) + mpq_class(x.x[3]);
}

} // namespace inexact

TEST_CASE("graze::solve in dd_real errs within its bound") { inexact::check_all<dd_real>(300); }
TEST_CASE("graze::solve in qd_real errs within its bound") { inexact::check_all<qd_real>(100); }
