// Rounding errors of the built-in types, within the constants that the compiler derives.
#include "round_off.hpp"

TEST_CASE("float errs within the derived bounds") { round_off::check_type<float>(); }
TEST_CASE("double errs within the derived bounds") { round_off::check_type<double>(); }
TEST_CASE("long double errs within the derived bounds") { round_off::check_type<long double>(); }
