#include "inexact.hpp"

#include <graze/number/adapter/float128.hpp>

TEST_CASE("graze::solve in long double errs within its bound") { inexact::check_all<long double>(500); }
#if GRAZE_HAS_FLOAT128
TEST_CASE("graze::solve in __float128 errs within its bound") { inexact::check_all<__float128>(500); }
#endif
