// The laws, on pairs of every hard family.
#include "../property.hpp"
#include "../soak/more_families.hpp"
#include "laws.hpp"

#include <doctest/doctest.h>

#include <cstdint>

namespace {

template <int N, std::size_t Count>
families::pair_of_doubles<N> any_of(const std::array<families::family, Count>& drawn) {
    const auto which = property::in_range<std::size_t>(0, Count);
    const auto index = property::any<std::uint64_t>();
    return drawn[which].template draw<N>(1, index % (1U << 20U));
}

template <class A, class B>
void all_laws(const A& a, const B& b) {
    laws::axes(a, b);
    laws::presentation(a, b);
    laws::scaling(a, b);
    laws::collisions_have_times(a, b);
    laws::overlap_is_now(a, b);
}

template <int N>
void all_laws(const families::pair_of_doubles<N>& pair) {
    if (pair.kind == families::pair_kind::ball_ball) {
        all_laws(pair.a, pair.b);
        laws::larger_is_earlier(pair.a, pair.b);
    } else if (pair.kind == families::pair_kind::ball_plane) {
        all_laws(pair.a, pair.plane);
        laws::planes_are_met(pair.a, pair.plane);
    } else {
        all_laws(pair.a, pair.wall);
        if constexpr (N == 2) {
            laws::walls_lie_in_planes(pair.a, pair.wall);
        }
    }
}

template <int N>
bool holds_in() {
    return property::check([] { all_laws(any_of<N>(families::all_families)); }) &&
           property::check([] { all_laws(any_of<N>(families::more_families)); });
}

template <int N>
auto time_of_any() {
    const auto pair = any_of<N>(families::all_families);
    return pair.kind == families::pair_kind::ball_ball    ? answers::time_of(pair.a, pair.b)
           : pair.kind == families::pair_kind::ball_plane ? answers::time_of(pair.a, pair.plane)
                                                          : answers::time_of(pair.a, pair.wall);
}
template <int N>
bool times_are_ordered() {
    return property::check([] {
        const auto x = time_of_any<N>();
        const auto y = time_of_any<N>();
        laws::order(x, y, time_of_any<N>());
        laws::numbers_in_order(x, y);
    });
}

// The frame of reference in which b rests at the origin, or nearly so.
template <int N>
bool holds_in_other_frames() {
    int tried = 0, exact = 0;
    const bool holds = property::check([&] {
        const auto pair = any_of<N>(families::more_families);
        PROPERTY_PRE(pair.kind == families::pair_kind::ball_ball);
        ++tried;
        exact += laws::common_velocity(pair.a, pair.b, -pair.b.velocity) ? 1 : 0;
        exact += laws::common_velocity(pair.a, pair.b, pair.a.velocity) ? 1 : 0;
        exact += laws::common_position(pair.a, pair.b, -pair.b.position) ? 1 : 0;
        exact += laws::common_position(pair.a, pair.b, pair.a.position) ? 1 : 0;
    });
    CHECK(exact > 2 * tried); // of four each
    return holds;
}

} // namespace

TEST_CASE("Decisions do not depend on the axes, on how a thing is written, on the units") {
    CHECK(holds_in<2>());
    CHECK(holds_in<3>());
}

TEST_CASE("Decisions do not depend on the frame of reference") {
    CHECK(holds_in_other_frames<2>());
    CHECK(holds_in_other_frames<3>());
}

TEST_CASE("Times are in one order, whatever met whatever") {
    CHECK(times_are_ordered<2>());
    CHECK(times_are_ordered<3>());
}
