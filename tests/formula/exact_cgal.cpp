#include "exact.hpp"

#include <graze/number/adapter/cgal.hpp>

using lazy = CGAL::Lazy_exact_nt<CGAL::Gmpq>;

namespace CGAL {
static mpq_class rational_in(const Gmpq& x) { return mpq_class(x.mpq()); }
static mpq_class rational_in(const lazy& x) { return mpq_class(x.exact().mpq()); }
} // namespace CGAL

TEST_CASE("graze::solve in CGAL::Gmpq is exact") { exact::check_all<CGAL::Gmpq>(); }
TEST_CASE("graze::solve in CGAL::Lazy_exact_nt is exact") { exact::check_all<lazy>(); }
