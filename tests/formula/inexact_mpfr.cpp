#include "inexact.hpp"

#include <graze/number/adapter/mpfr.hpp>

namespace mp = boost::multiprecision;
using mpfr_float_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;

TEST_CASE("graze::solve in mpfr_float_50 errs within its bound") { inexact::check_all<mpfr_float_50>(100); }
