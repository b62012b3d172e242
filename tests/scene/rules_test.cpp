// The rules of a run in special cases: mirrors, overlaps, points, cascades, limits, exceptions.
#include "../property.hpp"
#include "exact_runs.hpp"

#include <graze/number/floating.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/scene/scene_of.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace rules_test {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
using balls = std::vector<graze::ball<2>>;
using planes = std::vector<graze::plane<2>>;
using walls = std::vector<graze::wall<2>>;
using plain = graze::plain_mechanics<2, double>;

std::string message_of(const graze::scene<2>& scene) {
    try {
        (void)run_exactly<2>(scene, {});
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}

// Four walls around the square from 0 to 1.
const walls box = {
    {{{0, 0}}, {{{{1, 0}}}}}, {{{1, 0}}, {{{{0, 1}}}}}, {{{1, 1}}, {{{{-1, 0}}}}}, {{{0, 1}}, {{{{0, -1}}}}}};

} // namespace

TEST_CASE("nothing happens in an empty scene, or to one ball") {
    CHECK(run_exactly<2>({}, {}).outcome.why == graze::ending::exhausted);
    const balls one = {{{{0, 0}}, {{1, 0}}, 1, 1}};
    const auto finished = run_exactly<2>({one, {}, {}}, {.time = 100, .events = 5});
    CHECK(finished.outcome.why == graze::ending::exhausted);
    CHECK(finished.outcome.events == 0);
    CHECK(finished.flights[0].since == 0);
}

TEST_CASE("a scene of other types runs as one of graze's own") {
    struct place {
        double x, y;
    };
    struct particle {
        place position, velocity;
        double radius;
    };
    struct half_plane {
        place point, normal;
    };
    std::vector<particle> discs;
    std::vector<graze::ball<2>> own;
    for (int i = 0; i < 9; ++i) {
        discs.push_back({{i + 0.5, 0.25 * i}, {1.0 - i % 3, 0.5 * (i % 2)}, 0.125 + 0.03125 * i});
        own.push_back(graze::shape_of(discs.back()));
    }
    const std::array<half_plane, 2> ends{{{{0, 0}, {1, 0}}, {{10, 0}, {2, 0}}}};
    const planes own_ends = {{{{0, 0}}, {{1, 0}}}, {{{10, 0}}, {{2, 0}}}};
    auto foreign = graze::scene_of(discs, ends, box);
    const auto moved = std::move(foreign);
    const auto as = [](const finished_run<2>& r) { return std::pair(r.outcome.events, r.outcome.why); };
    const auto a = run_exactly<2>(moved, {.events = 50}), b = run_exactly<2>({own, own_ends, box}, {.events = 50});
    CHECK(as(a) == as(b));
    CHECK(a.outcome.events > 10);
    for (std::size_t i = 0; i < own.size(); ++i) {
        CHECK(a.flights[i].since == b.flights[i].since);
        CHECK(a.flights[i].state.velocity == b.flights[i].state.velocity);
    }
}

TEST_CASE("bad input is named") {
    balls two = {{{{0, 0}}, {{1, 0}}, 1, 1}, {{{5, 0}}, {{0, 0}}, -1, 1}};
    CHECK(message_of({two, {}, {}}) == "ball 1: radius is negative");
    two[1].radius = 1;
    two[0].velocity[1] = std::nan("");
    CHECK(message_of({two, {}, {}}) == "ball 0: velocity is not finite");
    two[0].velocity[1] = 0;
    two[1].mass = 0;
    CHECK(message_of({two, {}, {}}) == "ball 1: mass is not positive");
    two[1].mass = 1;
    const planes flat = {{{{9, 9}}, {{1, 0}}}, {{{0, 0}}, {{0, 0}}}};
    CHECK(message_of({two, flat, {}}) == "plane 1: normal is zero");
    const walls point = {{{{0, 0}}, {{{{0, 0}}}}}};
    CHECK(message_of({two, {}, point}) == "wall 0: edge is zero");
    const std::vector<graze::ball<3>> one = {{{{0, 0, 5}}, {{0, 0, -1}}, 1, 1}};
    const std::vector<graze::wall<3>> flags = {{{{0, 0, 0}}, {{{{1, 0, 0}}, {{0, 1, 0}}}}},
                                               {{{0, 0, 0}}, {{{{1, 2, 0}}, {{2, 4, 0}}}}}};
    CHECK_THROWS_WITH_AS((void)run_exactly<3>({one, {}, flags}, {}), "ball 0 and wall 1: wall: edges are parallel",
                         std::domain_error);
}

TEST_CASE("two infinite masses that meet are named, and nothing is lost") {
    const balls three = {
        {{{0, 0}}, {{1, 0}}, 1, infinite}, {{{9, 0}}, {{-1, 0}}, 1, infinite}, {{{0, 3}}, {{0, -2}}, 1, 1}};
    graze::run<plain> run(graze::scene<2>{three, {}, {}});
    CHECK(run.advance({.time = 3}).events == 1);
    const auto before = run.in_flight(2);
    for (int i = 0; i < 2; ++i) {
        try {
            run.advance({});
            FAIL("it goes on");
        } catch (const std::domain_error& e) {
            CHECK(std::string(e.what()) ==
                  "ball 0 and ball 1: both masses are infinite, and they meet at about t = 3.5");
        }
    }
    CHECK(run.in_flight(2).state.velocity == before.state.velocity);
    CHECK(run.advance({.time = 3}).why == graze::ending::time);
    CHECK(message_of({three, {}, {}}) == "ball 0 and ball 1: both masses are infinite, and they meet at about t = 3.5");
}

TEST_CASE("a mirror keeps its flight, whatever it meets") {
    const balls mirrors = {
        {{{0, 0}}, {{0, 0}}, 0.5, infinite}, {{{4, 0}}, {{0, 0}}, 0.5, infinite}, {{{2, 0}}, {{1, 0}}, 0.25, 1}};
    std::uint64_t told = 0;
    const auto finished = run_exactly<2>({mirrors, {}, {}}, {.events = 100}, [&](const exact_event<2>& e) {
        CHECK(e.who == graze::scene_pair{graze::partner::ball, e.who.a, e.who.b});
        ++told;
        return true;
    });
    CHECK(told == 100);
    CHECK(finished.flights[0].since == 0);
    CHECK(finished.flights[1].since == 0);
    CHECK(finished.flights[2].since == 1.25 + 99 * 2.5);
}

TEST_CASE("a mirror that meets a plane or a wall is told, and flies on") {
    const planes flat = {{{{0, 0}}, {{1, 0}}}};
    const walls upright = {{{{7, -1}}, {{{{0, 2}}}}}};
    for (const double x : {-3.0, -0.5}) { // it comes to the plane; it cuts the plane
        const balls mirror = {{{{x, 0}}, {{1, 0}}, 1, infinite}};
        std::vector<graze::scene_pair> met;
        const auto finished = run_exactly<2>({mirror, flat, upright}, {}, [&](const exact_event<2>& e) {
            met.push_back(e.who);
            return true;
        });
        CHECK(finished.outcome.why == graze::ending::exhausted);
        CHECK(met == std::vector<graze::scene_pair>{{graze::partner::plane, 0, 0}, {graze::partner::wall, 0, 0}});
        CHECK(finished.flights[0].since == 0);
        CHECK(finished.flights[0].state.velocity[0] == 1);
    }
}

TEST_CASE("what overlaps and approaches is resolved at once, what parts is left alone") {
    balls two = {{{{0, 0}}, {{1, 0}}, 1, 1}, {{{1, 0}}, {{0, 0}}, 1, 1}};
    auto finished = run_exactly<2>({two, {}, {}}, {});
    CHECK(finished.outcome.events == 1);
    CHECK(finished.flights[0].since == 0);
    CHECK(finished.flights[1].state.velocity[0] == 1);
    two[0].velocity[0] = -1;
    CHECK(run_exactly<2>({two, {}, {}}, {}).outcome.events == 0);

    const planes flat = {{{{0, 0.5}}, {{0, 1}}}};
    const balls cuts = {{{{0, 0}}, {{0, 1}}, 1, 1}};
    finished = run_exactly<2>({cuts, flat, {}}, {});
    CHECK(finished.outcome.events == 1);
    CHECK(finished.flights[0].state.velocity[1] == -1);
}

TEST_CASE("an event that shares a ball with one that another of the same time brings about is chosen") {
    const balls four = {{{{-3, 0}}, {{1, 0}}, 0.5, 2},
                        {{{0, 0}}, {{0, 0}}, 0.5, 3},
                        {{{1, 0}}, {{0, 0}}, 0.5, 5},
                        {{{4, 0}}, {{-1, 0}}, 0.5, 7}};
    std::vector<std::pair<graze::scene_pair, bool>> told;
    const auto finished = run_exactly<2>({four, {}, {}}, {.time = 2}, [&](const exact_event<2>& e) {
        told.emplace_back(e.who, e.chosen);
        return true;
    });
    REQUIRE(told.size() >= 3);
    CHECK(told[0] == std::pair(graze::scene_pair{graze::partner::ball, 0, 1}, false)); // causes that of 1 and 2
    CHECK(told[1] == std::pair(graze::scene_pair{graze::partner::ball, 2, 3}, true));
    CHECK(told[2] == std::pair(graze::scene_pair{graze::partner::ball, 1, 2}, false));
    CHECK(finished.outcome.choices == 1);
    // They share a mirror. Its flight does not change, so nothing had to be chosen.
    balls five = four;
    five[1].mass = five[2].mass = infinite;
    CHECK(run_exactly<2>({five, {}, {}}, {.time = 2}).outcome.choices == 0);
}

TEST_CASE("of grazes at one time none is lost, and a hit beside them is as if they were not") {
    const auto events_of = [](const graze::scene<2>& scene) {
        std::vector<graze::scene_pair> told;
        const auto finished = run_exactly<2>(scene, {.time = 6}, [&](const exact_event<2>& e) {
            CHECK(e.when == 5);
            told.push_back(e.who);
            return true;
        });
        std::sort(told.begin(), told.end());
        return std::pair(told, finished.flights[0].state.velocity);
    };
    using graze::partner;
    const graze::vec<2, double> on{{1, 0}}, back{{-1, 0}};
    const balls one = {{{{-5, 0}}, {{1, 0}}, 1, 1}};
    const walls gate = {{{{0, 1}}, {{{{0, 3}}}}}, {{{0, -1}}, {{{{0, -3}}}}}};
    const std::vector<graze::scene_pair> both = {{partner::wall, 0, 0}, {partner::wall, 0, 1}};
    CHECK(events_of({one, {}, gate}) == std::pair(both, on));
    balls three = {{{{-5, 1}}, {{1, 0}}, 0.5, 1}, {{{0, 0}}, {{0, 0}}, 0.5, 1}, {{{0, 2}}, {{0, 0}}, 0.5, 1}};
    const std::vector<graze::scene_pair> pair = {{partner::ball, 0, 1}, {partner::ball, 0, 2}};
    CHECK(events_of({three, {}, {}}) == std::pair(pair, on));
    // Halfway between two others, at a place that is no double.
    const balls third = {{{{-5, 0}}, {{1, 0}}, 0.1, 1}};
    const walls narrow = {{{{0, 0.1}}, {{{{0, 3}}}}}, {{{0, -0.1}}, {{{{0, -3}}}}}};
    CHECK(events_of({third, {}, narrow}).first.size() == 2);
    // The mirror, which is hit at the same time, comes last in canonical order.
    three.push_back({{{1, 1}}, {{0, 0}}, 0.5, infinite});
    const auto [told, velocity] = events_of({three, {}, {}});
    CHECK(std::count(told.begin(), told.end(), graze::scene_pair{partner::ball, 0, 3}) == 1);
    CHECK(velocity == back);
}

TEST_CASE("a cascade without end is reported") {
    // Two infinite masses approach each other and both overlap the ball between them. The left one, whose number is
    // first, makes the ball's speed 3/2; each of the others adds 2.
    const balls press = {{{{-1.0625, 0}}, {{1, 0}}, 1, infinite},
                         {{{1.0625, 0}}, {{-1, 0}}, 1, infinite},
                         {{{0, 0}}, {{0.5, 0}}, 0.125, 1}};
    const auto finished = run_exactly<2>({press, {}, {}}, {.cascade = 500});
    CHECK(finished.outcome.why == graze::ending::cascade);
    CHECK(finished.outcome.events == 500);
    CHECK(finished.flights[2].since == 0);
    CHECK(std::fabs(finished.flights[2].state.velocity[0]) == 1.5 + 2 * 499);
}

TEST_CASE("events of exactly the time asked for are done, and a later call goes on") {
    const balls one = {{{{3, 0}}, {{-1, 0}}, 1, 1}};
    const planes two = {{{{0, 0}}, {{1, 0}}}, {{{10, 0}}, {{1, 0}}}};
    graze::run<plain> run(graze::scene<2>{one, two, {}});
    CHECK(run.advance({.time = 1.5}).events == 0);
    CHECK(run.advance({.time = 2}).events == 1);
    const auto at_last = run.advance({.time = 10, .events = 7});
    CHECK(at_last.events == 1);
    CHECK(at_last.why == graze::ending::time);
    CHECK(run.advance({.events = 3}).why == graze::ending::events);
    CHECK_THROWS_WITH_AS(run.advance({.time = std::nan("")}), "the time limit is not a number", std::domain_error);
    CHECK(run.advance({.events = 1}).events == 1);
}

TEST_CASE("a clock is set back where every time stays exact, and between instants") {
    const balls two = {{{{3, 0}}, {{-1, 0}}, 1, 1}, {{{4, 5}}, {{-1, 0}}, 2, 1}};
    const planes ends = {{{{0, 0}}, {{1, 0}}}, {{{10, 0}}, {{1, 0}}}};
    graze::run<plain> run(graze::scene<2>{two, ends, {}});
    CHECK(run.advance({.events = 1}).events == 1); // one of two at t = 2
    CHECK_FALSE(run.set_clock_back(2));
    CHECK(run.advance({.time = 3}).events == 1);
    CHECK_FALSE(run.set_clock_back(0x1p-60));
    CHECK(run.in_flight(0).since == 2);
    CHECK(run.set_clock_back(3)); // predicted events are predicted again
    CHECK(run.in_flight(0).since == -1);
    CHECK(run.in_flight(1).since == -1);
    const auto later = run.advance({.time = 5}, [](const graze::run_event<plain>& e) { // at 8 on the old clock
        CHECK(e.who == graze::scene_pair{graze::partner::plane, 1, 1});
        CHECK(e.when == 5);
    });
    CHECK(later.events == 1);
    CHECK(run.advance({.time = 7}).events == 1); // and at 10
    CHECK(run.in_flight(0).since == 7);
    CHECK(run.in_flight(0).state.position == graze::vec<2, double>{9, 0});
}

TEST_CASE(
    "an observer that sets the clock back, which it must not, is refused within an instant and else does no harm") {
    const balls two = {{{{3, 0}}, {{-1, 0}}, 1, 1}, {{{4, 5}}, {{-1, 0}}, 2, 1}};
    const planes ends = {{{{0, 0}}, {{1, 0}}}, {{{10, 0}}, {{1, 0}}}};
    graze::run<plain> run(graze::scene<2>{two, ends, {}});
    std::vector<double> times;
    const auto done = run.advance({.events = 4}, [&](const graze::run_event<plain>& e) {
        times.push_back(e.when);
        if (times.size() <= 2) {
            CHECK(run.set_clock_back(2) == (times.size() == 2));
        }
    });
    CHECK(done.events == 4);
    CHECK(times == std::vector<double>{2, 2, 6, 8});
    CHECK(run.in_flight(0).since == 8);
    CHECK(run.in_flight(1).since == 6);
}

TEST_CASE("other states are checked, and a run goes on from them as from a start") {
    const balls two = {{{{0, 0}}, {{1, 0}}, 1, 1}, {{{9, 0}}, {{-1, 0}}, 1, 1}, {{{-9, 5}}, {{1, 0}}, 1, infinite}};
    const planes upright = {{{{0, 0}}, {{1, 0}}}};
    graze::run<plain> run(graze::scene<2>{two, {}, {}});
    CHECK(run.advance({.time = 4}).events == 1); // at 3.5
    const auto message = [&](auto change) -> std::string {
        try {
            run.restate([&](int i, graze::flight<2> f) {
                if (i == 1) {
                    change(f);
                }
                return f;
            });
        } catch (const std::domain_error& e) {
            return e.what();
        }
        return "";
    };
    CHECK(message([](auto& f) { f.state.position[1] = std::nan(""); }) == "ball 1: position is not finite");
    CHECK(message([](auto& f) { f.state.velocity[0] = infinite; }) == "ball 1: velocity is not finite");
    CHECK(message([](auto& f) { f.since = infinite; }) == "ball 1: time is not finite");
    CHECK(message([](auto& f) { f.state.radius = 2; }) == "ball 1: radius has changed");
    CHECK(message([](auto& f) { f.state.mass = 2; }) == "ball 1: mass has changed");
    CHECK(message([](auto& f) { f.since = 3; }) == "ball 1: state is earlier than the last event");
    CHECK(run.in_flight(1).state.velocity[0] == 1);
    CHECK(run.advance({}).why == graze::ending::exhausted);
    CHECK(message([](auto& f) { f.state = {{{4, 0}}, {{-2, 0}}, 1, 1}; }) == ""); // into the other, which it overlaps
    CHECK(run.advance({}).events == 1);
    CHECK(run.in_flight(1).since == 3.5);

    graze::run<plain> mirror(graze::scene<2>{two, upright, {}}); // it comes to the plane at 8, which is told once
    CHECK(mirror.advance({.time = 9}).events == 3);
    mirror.restate([&](int i, const graze::flight<2>& f) {
        return i == 2 ? f : graze::flight<2>{mirror.rules().ball_at(f, 9), 9};
    });
    std::uint64_t told = 0;
    mirror.advance({.events = 10}, [&](const graze::run_event<plain>& e) { told += e.who.a == 2 ? 1 : 0; });
    CHECK(told == 0);
}

TEST_CASE("states of the last event's time are taken as it was rounded, and what touches then is not lost") {
    using floats = graze::exact_mechanics<2, float>;
    std::mt19937_64 random(5);
    const auto between = [&](int low, int high) {
        return static_cast<float>(low) +
               static_cast<float>(high - low) * std::ldexp(static_cast<float>(random() >> 40), -24);
    };
    int earlier = 0; // how often the time was rounded down
    for (int i = 0; i < 50; ++i) {
        const std::vector<graze::ball<2, float>> two = {{{{between(-9, -5), 0}}, {{between(1, 2), 0}}, 1, 1},
                                                        {{{between(5, 9), 0}}, {{between(-2, -1), 0}}, 1, 1}};
        graze::run<floats> run(graze::scene<2, float>{two, {}, {}});
        bool rounded_down = false;
        run.advance({}, [&](const graze::run_event<floats>& e) { rounded_down = e.when > e.after_a.since; });
        earlier += rounded_down ? 1 : 0;
        run.restate([](int, graze::flight<2, float> f) { // moved back into each other
            f.state.position[0] *= 0.5F;
            f.state.velocity[0] = -f.state.velocity[0];
            return f;
        });
        CHECK(run.advance({}).events == 1);
    }
    CHECK(earlier > 10);
}

TEST_CASE("a cascade is over when other states are given") {
    const balls three = {
        {{{-2, 0}}, {{1, 0}}, 1, infinite}, {{{2, 0}}, {{-1, 0}}, 1, infinite}, {{{0, 0}}, {{0, 0}}, 1.5, 1}};
    graze::run<plain> run(graze::scene<2>{three, {}, {}});
    CHECK(run.advance({}).why == graze::ending::cascade);
    run.restate([](int i, graze::flight<2> f) {
        return i == 2 ? graze::flight<2>{{{{-2, 2}}, {{0, -1}}, 1.5, 1}, f.since} : f; // moved into one of the mirrors
    });
    CHECK(run.advance({.events = 1}).events == 1);
}

TEST_CASE("a point that is put on the other side of what it left is there") {
    const balls point = {{{{2, 0}}, {{-1, 0}}, 0, 1}};
    const planes upright = {{{{0, 0}}, {{1, 0}}}};
    graze::run<plain> run(graze::scene<2>{point, upright, {}});
    CHECK(run.advance({}).events == 1);
    run.restate([](int, graze::flight<2> f) {
        f.state.position[0] = -5;
        f.since = 4;
        return f;
    });
    CHECK(run.advance({.events = 1}).events == 1);
    CHECK(run.in_flight(0).since == 9);
    CHECK(run.in_flight(0).state.velocity[0] == -1);
}

TEST_CASE("an observer stops a run, and its exception loses nothing") {
    const balls one = {{{{3, 0}}, {{-1, 0}}, 1, 1}};
    const planes two = {{{{0, 0}}, {{1, 0}}}, {{{10, 0}}, {{1, 0}}}};
    graze::run<plain> run(graze::scene<2>{one, two, {}});
    CHECK(run.advance({}, [](const auto&) { return false; }).why == graze::ending::stopped);
    CHECK_THROWS_AS(run.advance({}, [](const auto&) { throw std::runtime_error("seen enough"); }), std::runtime_error);
    CHECK(run.in_flight(0).since == 10);
    CHECK(run.advance({.events = 1}).events == 1);
    CHECK(run.in_flight(0).since == 18);
}

TEST_CASE("a point stays on its side") {
    CHECK(property::check([] {
        const auto fraction = [] { return property::in_range(-999, 1000) * 0.001; };
        const balls point = {{{{0.5 + 0.4 * fraction(), 0.5 + 0.4 * fraction()}}, {{fraction(), fraction()}}, 0, 1},
                             {{{0.5, 0.5}}, {{fraction(), fraction()}}, 0.0625, 1e6}};
        PROPERTY_PRE(std::hypot(point[0].position[0] - 0.5, point[0].position[1] - 0.5) > 0.0625);
        const auto finished = run_exactly<2>({point, {}, box}, {.events = 300}, [](const exact_event<2>& e) {
            if (e.who.a == 0) {
                PROPERTY_ASSERT(std::fabs(e.after_a.state.position[0] - 0.5) < 0.5 + 1e-12);
                PROPERTY_ASSERT(std::fabs(e.after_a.state.position[1] - 0.5) < 0.5 + 1e-12);
            }
            return true;
        });
        PROPERTY_ASSERT(finished.outcome.why == graze::ending::events ||
                        finished.outcome.why == graze::ending::exhausted ||
                        finished.outcome.why == graze::ending::cascade);
    }));
}

TEST_CASE("a point that a ball pins to a wall does not pass through it") {
    // The point bounces between a wall and a heavy ball that approaches until it turns.
    const balls pinned = {{{{0.3, 0.1}}, {{-1, 0}}, 0, 1}, {{{2.3, 0.1}}, {{-1, 0}}, 0.7, 1e6}};
    const planes wall = {{{{0.1, 0}}, {{1, 0}}}};
    const auto finished = run_exactly<2>({pinned, wall, {}}, {}, [](const exact_event<2>& e) {
        CHECK(e.after_a.state.position[0] > 0.1 - 1e-12);
        return true;
    });
    CHECK(finished.outcome.why == graze::ending::exhausted);
    CHECK(finished.outcome.events == 3141);
    CHECK(finished.flights[0].state.velocity[0] > 0);
}

TEST_CASE("a point that comes to a corner leaves it on the side from which it came") {
    const balls point = {{{{1.5, 1.5}}, {{-1, -1}}, 0, 1}};
    const planes edges = {{{{0.5, 0.5}}, {{1, 0}}}, {{{0.5, 0.5}}, {{0, 1}}}};
    const walls sides = {{{{0.5, 0.5}}, {{{{1, 0}}}}}, {{{0.5, 0.5}}, {{{{0, 1}}}}}};
    for (const auto& corner : {graze::scene<2>{point, edges, {}}, graze::scene<2>{point, {}, sides}}) {
        const auto finished = run_exactly<2>(corner, {});
        CHECK(finished.outcome.events == 2);
        CHECK(finished.outcome.choices == 1);
        CHECK(finished.flights[0].since == 1);
        CHECK(finished.flights[0].state.velocity == graze::vec<2, double>{{1, 1}});
        graze::run<plain> run(corner);
        CHECK(run.advance({}).events == 2);
        CHECK(run.in_flight(0).state.velocity == graze::vec<2, double>{{1, 1}});
    }
    // A mirror stands on the plane; and a wedge of atan(1/4), which a straightened way leaves after 13 faces.
    const balls at_mirror = {{{{1, 0}}, {{-1, 0}}, 0, 1}, {{{0, -1}}, {{0, 0}}, 1, infinite}};
    const planes upright = {{{{0, 0}}, {{1, 0}}}};
    auto finished = run_exactly<2>({at_mirror, upright, {}}, {});
    CHECK(finished.outcome.events == 2);
    CHECK(finished.flights[0].state.velocity == graze::vec<2, double>{{1, 0}});
    const balls into_wedge = {{{{8, 1}}, {{-8, -1}}, 0, 1}};
    const planes wedge = {{{{0, 0}}, {{0, 1}}}, {{{0, 0}}, {{-1, 4}}}};
    finished = run_exactly<2>({into_wedge, wedge, {}}, {});
    CHECK(finished.outcome.events == 13);
    const auto& out = finished.flights[0].state.velocity;
    CHECK(out[1] > 0);
    CHECK(out[0] > 4 * out[1]);
}

TEST_CASE("a point in a box with slanted sides stays in it, into the corners too") {
    CHECK(property::check([] {
        // Walls with corners at ±(1, k) and ±(k, -1), whose sides follow no grid of doubles.
        const double k = property::in_range(1, 9) * 0.1;
        const graze::vec<2, double> corners[] = {{{1, k}}, {{-k, 1}}, {{-1, -k}}, {{k, -1}}};
        planes box_of_planes;
        for (int i = 0; i < 4; ++i) {
            const auto &p = corners[i], &q = corners[(i + 1) % 4];
            box_of_planes.push_back(graze::plane<2>{p, {{p[1] - q[1], q[0] - p[0]}}});
        }
        const auto& aim = corners[property::in_range(0, 4)];
        const double speed = property::in_range(1, 99) * 0.01;
        const balls point = {{{{0, 0}}, speed * aim, 0, 1}};
        const auto finished = run_exactly<2>({point, box_of_planes, {}}, {.events = 40});
        const auto& f = finished.flights[0].state;
        PROPERTY_ASSERT(finished.outcome.why == graze::ending::events);
        PROPERTY_ASSERT(graze::squared_norm(f.position) < 1.01 * (1 + k * k));
    }));
}

} // namespace rules_test
