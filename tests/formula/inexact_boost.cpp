#include "inexact.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace mp = boost::multiprecision;
template <unsigned Digits>
using cpp_bin_float = mp::number<mp::cpp_bin_float<Digits>, mp::et_off>;

TEST_CASE("graze::solve in cpp_bin_float_50 errs within its bound") { inexact::check_all<cpp_bin_float<50>>(100); }
TEST_CASE("graze::solve in cpp_bin_float_100 errs within its bound") { inexact::check_all<cpp_bin_float<100>>(100); }
