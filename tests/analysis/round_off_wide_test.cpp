// Rounding errors of wider types, up to 100 digits, within the constants that the compiler derives.
#include "round_off.hpp"

#include <graze/number/adapter/boost.hpp>
#include <graze/number/adapter/float128.hpp>
#include <graze/number/adapter/mpfr.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace mp = boost::multiprecision;
using cpp_bin_float_100 = mp::number<mp::cpp_bin_float<100>, mp::et_off>;
using mpfr_float_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;

TEST_CASE("__float128 errs within the derived bounds") { round_off::check_type<__float128>(); }
TEST_CASE("mpfr_float_50 errs within the derived bounds") { round_off::check_type<mpfr_float_50>(); }
TEST_CASE("cpp_bin_float_100 errs within the derived bounds") { round_off::check_type<cpp_bin_float_100>(); }
