#include "adapter.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/gmp.hpp>

namespace mp = boost::multiprecision;
using adapter::kind;
using rational = mp::number<mp::gmp_rational, mp::et_off>;
using integer = mp::number<mp::gmp_int, mp::et_off>;

static_assert(adapter::satisfies<rational, kind::exact_field, false, false>());
static_assert(adapter::satisfies<integer, kind::exact_ring, false, false>());
static_assert(!graze::number<mp::mpq_rational> && !graze::number<mp::mpz_int>);

TEST_CASE("GMP through Boost") {
    adapter::check<rational>("mpq_rational");
    adapter::check<integer>("mpz_int");
}
