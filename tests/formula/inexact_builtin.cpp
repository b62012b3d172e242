#include "inexact.hpp"

TEST_CASE("graze::solve in float errs within its bound") { inexact::check_all<float>(500); }
TEST_CASE("graze::solve in double errs within its bound") { inexact::check_all<double>(500); }
