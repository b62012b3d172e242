#include "exact.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/gmp.hpp>

namespace mp = boost::multiprecision;
using mpq_rational = mp::number<mp::gmp_rational, mp::et_off>;

namespace boost::multiprecision {
static mpq_class rational_in(const ::mpq_rational& x) { return mpq_class(x.backend().data()); }
} // namespace boost::multiprecision

TEST_CASE("graze::solve in Boost's mpq_rational is exact") { exact::check_all<mpq_rational>(); }
