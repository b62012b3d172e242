#include "types.hpp"

TEST_CASE("The predicates of double agree with the oracle") {
    types::check_all<2, double>();
    types::check_all<3, double>();
}
