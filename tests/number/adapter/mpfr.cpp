#include "adapter.hpp"

#include <graze/number/adapter/mpfr.hpp>

namespace mp = boost::multiprecision;
using mpfr_float_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;
using on_the_stack = mp::number<mp::mpfr_float_backend<50, mp::allocate_stack>, mp::et_off>;

static_assert(adapter::satisfies<mpfr_float_50, adapter::kind::inexact_field, true, true>());
static_assert(adapter::satisfies<on_the_stack, adapter::kind::inexact_field, true, true>());
static_assert(!graze::number<mp::mpfr_float_50>);                                 // expression templates
static_assert(!graze::number<mp::number<mp::mpfr_float_backend<0>, mp::et_off>>); // its precision is chosen at run time

TEST_CASE("MPFR through Boost") {
    adapter::check<mpfr_float_50>("mpfr_float_50");
    adapter::check_digits<mpfr_float_50>();
    adapter::check_root<mpfr_float_50>(0x1p-168);
    adapter::check_fma<mpfr_float_50>();
}
