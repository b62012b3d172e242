#include "exact.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_int.hpp>

namespace mp = boost::multiprecision;
using cpp_rational = mp::number<mp::cpp_rational_backend, mp::et_off>;

namespace boost::multiprecision {
static mpq_class rational_in(const cpp_rational& x) { return mpq_class(x.str()); }
} // namespace boost::multiprecision

TEST_CASE("graze::solve in cpp_rational is exact") { exact::check_all<cpp_rational>(); }
