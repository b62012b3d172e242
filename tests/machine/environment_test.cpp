// The probe of the floating-point environment detects every state in which error-free transforms would fail.
#include "../environments/state.hpp"

#include <graze/machine/environment.hpp>
#include <graze/machine/fence.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace environments;

TEST_CASE("only rounding to nearest with subnormals kept is trusted") {
    save_state();
    static_assert(graze::detail::has_error_free_doubles);
    CHECK(graze::detail::rounds_to_nearest());
    CHECK(graze::detail::calculates_to_nearest());
    for (const rounding direction : {rounding::nearest, rounding::upward, rounding::downward, rounding::towards_zero}) {
        for (const bool flush : {false, true}) {
            if (flush && !can_flush()) {
                continue;
            }
            const bool set = set_state(direction, flush);
            const bool trusted = graze::detail::rounds_to_nearest();
            const bool calculated = graze::detail::calculates_to_nearest();
            restore_state();
            REQUIRE(set);
            CAPTURE(name_of(direction));
            CAPTURE(flush);
            CHECK(trusted == (direction == rounding::nearest && !flush));
            CHECK(calculated == trusted);
        }
    }
}

TEST_CASE("a fence passes pairs of doubles on, as lanes are where no register holds two") {
    struct pair {
        double first, second;
    };
    const pair x = graze::detail::settled(pair{1, 2});
    CHECK(x.first == 1);
    CHECK(x.second == 2);
}
