#include "answers_of_type.hpp"
#include "types.hpp"

TEST_CASE("The predicates of float agree with the oracle") {
    types::check_all<2, float>();
    types::check_all<3, float>();
}
