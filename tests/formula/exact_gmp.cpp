#include "exact.hpp"

#include <graze/number/adapter/gmp.hpp>

namespace graze {
static mpq_class rational_in(const gmp_rational& x) { return x.value(); }
} // namespace graze

TEST_CASE("graze::solve in mpq_class is exact") { exact::check_all<graze::gmp_rational>(); }
