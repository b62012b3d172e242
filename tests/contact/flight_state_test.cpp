// Decisions, orders of times and contacts of flights do not depend on the rounding direction or on whether subnormals
// are flushed.
#include "../environments/state.hpp"
#include "../predicate/flight_answers.hpp"
#include "../predicate/flight_families.hpp"

#include <graze/classify.hpp>
#include <graze/time_of_impact.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace {

using environments::rounding;
using pair = flight_families::pair<3>;

// Drawn before the state is changed. Some have epochs, or epochs and velocities, at the ends of the range.
std::vector<pair> drawn() {
    std::vector<pair> all;
    for (std::uint64_t index = 0; index < 400; ++index) {
        auto p = flight_families::draw<3>(static_cast<unsigned>(index % 5), 31, index);
        if (index % 7 == 3) {
            const double unit = std::ldexp(1.0, -1074 + static_cast<int>(index % 60));
            p.a.since *= unit;
            p.b.since *= unit;
        }
        if (index % 7 == 5 && index % 5 < 2) {
            const int power = static_cast<int>(index % 13) * 150 - 900;
            for (auto* f : {&p.a, &p.b}) {
                f->since = std::ldexp(f->since, power);
                for (double& u : f->state.velocity.component) {
                    u = std::ldexp(u, -power);
                }
            }
        }
        all.push_back(p);
    }
    // The time is negative and rounded to zero.
    const double early = -0x1p-1074;
    all.push_back(
        {{{{{-0x1.0000000000003p-722, -0x1.3bdc784f08a12p-748, 0}}, {{0x1.f553168c136f3p+301, 0, 0}}, 0x1p-723}, early},
         {{{{0, 0, 0}}, {{0, 0, 0}}, 0x1p-723}, early}});
    // An epoch that a mode reads as zero, in which a ball flies as far as the two are apart.
    all.push_back({{{{{0x1.504ce87e3f122p+0, 0x1.635d2e6d9d18cp+0, 0}},
                     {{-0x1.d5784284e1bd8p+1019, 0x1.619615360dc1p+1021, 0}},
                     0x1.dc1eb5bbc2ed4p-4},
                    0x0.a91ad062e3524p-1022},
                   {{{{0x1.a7299fd90946p-2, 0x1.41359e041508ep+0, 0}},
                     {{0x1.e3183d479fd74p+1021, 0x1.af1f130f0a556p+1021, 0}},
                     0x1.90ac46596c4cp-5},
                    0}});
    // Instants that overflow once they are scaled, to the largest double where results are not rounded up.
    all.push_back({{{{{0x3p-500, 0, 0}}, {{-0x1p500, 0, 0}}, 0x1p-500}, 0x1p100},
                   {{{{0, 0, 0}}, {{0, 0, 0}}, 0x1p-500}, 0x1p101}});
    all.push_back({{{{{0x3p-500, 0, 0}}, {{-0x1p500, 0, 0}}, 0x1p-500}, -0x1p101},
                   {{{{0, 0, 0}}, {{0, 0, 0}}, 0x1p-500}, -0x1p100}});
    // An epoch that a mode reads as zero, of balls with a large velocity in common.
    all.push_back({{{{{0, 0x1p-20, 0}}, {{0x1p1001, -1, 0}}, 0x1p-24}, 0},
                   {{{{0, 0, 0}}, {{0x1p1001, 0, 0}}, 0x1p-24}, 0x1p-1023}});
    return all;
}

// What is asked in every state must be true.
template <class Ask>
void check_in_every_state(Ask ask) {
    environments::save_state();
    for (const auto direction : {rounding::nearest, rounding::upward, rounding::downward, rounding::towards_zero}) {
        for (const bool flush : {false, true}) {
            if (flush && !environments::can_flush()) {
                continue;
            }
            const bool set = environments::set_state(direction, flush);
            const bool right = ask();
            environments::restore_state();
            CAPTURE(name_of(direction));
            CAPTURE(flush);
            CHECK(set);
            CHECK(right);
        }
    }
}

std::vector<std::uint64_t> said_of(const std::vector<pair>& pairs) {
    std::vector<std::uint64_t> said;
    const auto number = [&](double x) { said.push_back(std::bit_cast<std::uint64_t>(x)); };
    const auto vector = [&](const graze::vec<3, double>& v) {
        for (const double& x : v.component) {
            number(x);
        }
    };
    std::optional<graze::impact_time<3>> last;
    for (const pair& p : pairs) {
        const auto found = flight_answers::of(p.a, p.b);
        said.push_back(static_cast<std::uint64_t>(found.what) * 2 + (found.overlaps ? 1 : 0));
        if (found.contact) {
            number(found.contact->time);
            vector(found.contact->position_a);
            vector(found.contact->position_b);
            vector(found.contact->normal);
            vector(found.contact->velocity_a);
            vector(found.contact->velocity_b);
            const auto rounded = flight_answers::rounded(*found.time);
            number(rounded.lower);
            number(rounded.upper);
            auto told = graze::stage::filter;
            said.push_back(last ? static_cast<std::uint64_t>(flight_answers::order_of(*found.time, *last, told)) : 0);
            last = found.time;
        }
    }
    return said;
}

} // namespace

TEST_CASE("Flights in every rounding direction, subnormals kept or flushed") {
    const auto pairs = drawn();
    const auto expected = said_of(pairs);
    REQUIRE(expected.size() > 2 * pairs.size());
    check_in_every_state([&] { return said_of(pairs) == expected; });
}

TEST_CASE("Balls with a large part in common, of which a mode takes the rest") {
    const graze::ball<3> a{{{0x1.4p-1022, 0x1p-876, 0}}, {{-1, 0, 0}}, 0x1p-1023};
    const graze::ball<3> b{{{0, 0x1p-876, 0}}, {{0, 0, 0}}, 0x1p-1022};
    const graze::ball<3> c{{{3, 0, 3}}, {{-0x1p-1022, 0x1p-876, -0x0.fp-1022}}, 1};
    const graze::ball<3> d{{{0, 0, 0}}, {{0, 0x1p-876, 0}}, 1};
    check_in_every_state([&] {
        return graze::classify(a, b) == graze::encounter::overlap && graze::classify(c, d) == graze::encounter::hit;
    });
}

TEST_CASE("The time of floats that overlap at a start that a mode reads as zero") {
    const graze::flight<2, float> a{{{{1, 0}}, {{-1, 0}}, 1}, 0x1p-140F};
    const graze::flight<2, float> b{{{{0, 0}}, {{0, 0}}, 1}, 0};
    check_in_every_state([&] {
        const auto time = graze::time_of_impact(a, b);
        return time && *time == 0x1p-140F && *time > 0.0F;
    });
}
