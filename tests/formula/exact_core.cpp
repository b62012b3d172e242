#include "exact.hpp"

#include <graze/number/adapter/cgal.hpp>

namespace CORE {
static Expr whole(const mpz_class& x) { return Expr(BigInt(x.get_str())); }
static bool equal(const Expr& x, const oracle::surd& y) {
    return x * whole(y.r) == whole(y.p) + whole(y.q) * sqrt(whole(y.d));
}
} // namespace CORE

TEST_CASE("graze::solve in CORE::Expr is exact") { exact::check_all<CORE::Expr>(); }
