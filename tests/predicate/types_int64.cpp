#include "answers_of_type.hpp"
#include "types.hpp"

TEST_CASE("The predicates of int64 agree with the oracle") {
    types::check_all<2, std::int64_t>();
    types::check_all<3, std::int64_t>();
}
