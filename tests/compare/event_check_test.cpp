// The check of events accepts what is true and refutes what is false, whoever says it.
#include "run/event_check.hpp"

#include <doctest/doctest.h>

#include <string>

namespace event_check_test {

using namespace compare;
using namespace compare::run;

namespace {

constexpr long bits = 100;
using plane_flight = graze::flight<2, certified>;

certified number(int x, int over = 1) { return {exact(x, over), bits}; }
graze::vec<2, certified> at(const certified& x, const certified& y) { return {{x, y}}; }

graze::ball<2, certified> ball_of(const graze::vec<2, certified>& x, const graze::vec<2, certified>& u,
                                  const certified& r) {
    return {x, u, r, number(1)};
}

constexpr graze::partner ball = graze::partner::ball, plane = graze::partner::plane, wall = graze::partner::wall;

// The check's message; empty if it accepts.
template <class F>
std::string said(F f) {
    try {
        f();
        return {};
    } catch (const refuted_event& error) {
        return error.what();
    } catch (const graze::undecided& error) {
        return std::string("open: ") + error.what();
    }
}

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// A point above three walls; the last one is met at t = 6 at (0, -5).
owned_scene<2, certified> point_and_walls() {
    owned_scene<2, certified> s;
    s.balls.push_back(ball_of(at(number(0), number(1)), at(number(0), number(-1)), number(0)));
    s.walls.push_back({at(number(3), number(0)), {at(number(1), number(0))}}); // beside the way
    s.walls.push_back({at(number(-1), number(-5)), {at(number(2), number(0))}});
    return s;
}

// Two balls of radius 1 that meet head on at t = 3 and a plane behind the second one.
owned_scene<2, certified> two_balls() {
    owned_scene<2, certified> s;
    s.balls.push_back(ball_of(at(number(0), number(0)), at(number(1), number(0)), number(1)));
    s.balls.push_back(ball_of(at(number(5), number(0)), at(number(0), number(0)), number(1)));
    s.planes.push_back({at(number(10), number(0)), at(number(2), number(0))});
    return s;
}

plane_flight flight_of(const certified& x, const certified& u, const certified& since) {
    return {ball_of(at(x, number(0)), at(u, number(0)), number(1)), since};
}

} // namespace

TEST_CASE("a collision away from its wall is refuted") {
    const auto scene = point_and_walls();
    event_check<2> check(scene);
    // On the line of wall 0, three units from its corner, where it meets the wall's plane at t = 1.
    const plane_flight back{ball_of(at(number(0), number(0)), at(number(0), number(1)), number(0)), number(1)};
    const std::string text = said([&] { check.event({wall, 0, 0}, number(1), back, nullptr); });
    CHECK(holds(text, "ball 0 and wall 0 do not touch"));
    CHECK(holds(text, "t = 1"));
    const plane_flight right{ball_of(at(number(0), number(-5)), at(number(0), number(1)), number(0)), number(6)};
    CHECK(said([&] { check.event({wall, 0, 1}, number(6), right, nullptr); }).empty());
    CHECK(said([&] { check.end_of_all(); }).empty());
}

TEST_CASE("an event that was passed over is seen at the next one, and at the end") {
    const auto scene = point_and_walls();
    event_check<2> check(scene);
    CHECK(holds(said([&] { check.end(number(7)); }), "ball 0 and wall 1 met before that"));
    CHECK(holds(said([&] { check.end_of_all(); }), "ball 0 and wall 1 met before that"));
    CHECK(said([&] { check.end(number(5)); }).empty());

    const auto balls = two_balls();
    event_check<2> other(balls);
    CHECK(holds(said([&] {
                    other.event({plane, 0, 0}, number(9), flight_of(number(9), number(-1), number(9)), nullptr);
                }),
                "ball 0 and ball 1 met before that"));
}

TEST_CASE("the first plane is not passed over") {
    const auto scene = two_balls();
    event_check<2> check(scene);
    const plane_flight a = flight_of(number(3), number(0), number(3)), b = flight_of(number(5), number(1), number(3));
    CHECK(said([&] { check.event({ball, 0, 1}, number(3), a, &b); }).empty());
    CHECK(said([&] { check.end(number(6)); }).empty());
    CHECK(holds(said([&] { check.end(number(8)); }), "ball 1 and plane 0 met before that"));
}

TEST_CASE("an event that is told after a later one is held against the way until then") {
    owned_scene<2, certified> s;
    s.balls.push_back(ball_of(at(number(0), number(0)), at(number(-1), number(0)), number(1)));
    s.balls.push_back(ball_of(at(number(4), number(8)), at(number(0), number(-1)), number(1)));
    s.planes.push_back({at(number(-3), number(0)), at(number(1), number(0))});
    s.planes.push_back({at(number(0), number(-3)), at(number(0), number(1))});
    event_check<2> check(s);
    const plane_flight up{ball_of(at(number(4), number(-2)), at(number(0), number(1)), number(1)), number(10)};
    CHECK(said([&] { check.event({plane, 1, 1}, number(10), up, nullptr); }).empty());
    // Back from the plane at t = 2, ball 0 comes to (4, 0) at t = 8, and so does ball 1 before it turns.
    const plane_flight back = flight_of(number(-2), number(1), number(2));
    CHECK(holds(said([&] {
                    check.event({plane, 0, 0}, number(2), back, nullptr);
                }),
                "ball 0 and ball 1 met before that"));
}

TEST_CASE("a ball that has bounced is not held against another one as if it had come from there") {
    owned_scene<2, certified> s;
    s.balls.push_back(ball_of(at(number(0), number(0)), at(number(1), number(0)), number(1)));
    s.balls.push_back(ball_of(at(number(4), number(10)), at(number(0), number(-1)), number(1)));
    s.planes.push_back({at(number(0), number(2)), at(number(0), number(1))});
    event_check<2> check(s);
    // Straight back from its bounce, ball 1 would have been at (4, 0) at t = 4, where ball 0 was.
    const plane_flight up{ball_of(at(number(4), number(3)), at(number(0), number(1)), number(1)), number(7)};
    CHECK(said([&] { check.event({plane, 1, 0}, number(7), up, nullptr); }).empty());
    CHECK(said([&] { check.end(number(9)); }).empty());
    CHECK(said([&] { check.end_of_all(); }).empty());
}

TEST_CASE("the true course of two balls and a plane passes") {
    const auto scene = two_balls();
    event_check<2> check(scene);
    const plane_flight a = flight_of(number(3), number(0), number(3)), b = flight_of(number(5), number(1), number(3));
    CHECK(said([&] { check.event({ball, 0, 1}, number(3), a, &b); }).empty());
    CHECK(said([&] {
              check.event({plane, 1, 0}, number(7), flight_of(number(9), number(-1), number(7)), nullptr);
          }).empty());
    const plane_flight c = flight_of(number(3), number(-1), number(11)),
                       d = flight_of(number(5), number(0), number(11));
    CHECK(said([&] { check.event({ball, 0, 1}, number(11), c, &d); }).empty());
    CHECK(said([&] { check.end_of_all(); }).empty());
}

TEST_CASE("in a scene that has a period images are met, none is left out, and places are whole periods apart") {
    owned_scene<2, certified> ring;
    ring.balls.push_back(ball_of(at(number(0), number(0)), at(number(1), number(0)), number(1)));
    ring.balls.push_back(ball_of(at(number(25), number(0)), at(number(0), number(0)), number(1)));
    ring.period = at(number(10), number(0));
    // The first ball gives its velocity to the second, which comes round and gives it back.
    const plane_flight a = flight_of(number(3), number(0), number(3)), b = flight_of(number(5), number(1), number(3));
    const auto says = [&](const certified& x, const certified& t) {
        event_check<2> check(ring);
        check.event({ball, 0, 1}, number(3), a, &b);
        const plane_flight c = flight_of(number(3), number(1), t), d = flight_of(x, number(0), t);
        return said([&] { check.event({ball, 0, 1}, t, c, &d); });
    };
    CHECK(says(number(1), number(9)).empty());
    CHECK(says(number(-29), number(9)).empty());
    CHECK(holds(says(number(2), number(9)), "laws of collision"));
    CHECK(holds(says(number(0), number(8)), "do not touch"));
    CHECK(holds(says(number(2), number(10)), "inside each other"));
    event_check<2> check(ring);
    check.event({ball, 0, 1}, number(3), a, &b);
    CHECK(said([&] { check.end(number(9)); }).empty());
    CHECK(holds(said([&] { check.end(number(10)); }), "met before that"));

    owned_scene<2, certified> gate; // at 6; one of its images is at -4
    gate.balls.push_back(ball_of(at(number(0), number(0)), at(number(-1), number(0)), number(1)));
    gate.walls.push_back({at(number(6), number(-1)), {at(number(0), number(2))}});
    gate.period = ring.period;
    event_check<2> passes(gate), turns(gate), strays(gate);
    CHECK(said([&] { passes.end(number(3)); }).empty());
    CHECK(holds(said([&] { passes.end(number(4)); }), "met before that"));
    const plane_flight back = flight_of(number(7), number(1), number(3)),
                       aside = flight_of(number(8), number(1), number(3));
    CHECK(said([&] { turns.event({wall, 0, 0}, number(3), back, nullptr); }).empty());
    CHECK(said([&] { turns.end(number(11)); }).empty());
    CHECK(holds(said([&] { turns.end(number(12)); }), "met before that"));
    CHECK(holds(said([&] { strays.event({wall, 0, 0}, number(3), aside, nullptr); }), "laws of collision"));
}

TEST_CASE("what breaks a law of collision is refuted") {
    const auto scene = two_balls();
    const auto says = [&](const certified& u, const certified& v, const certified& x, const certified& t) {
        event_check<2> check(scene);
        const plane_flight a = flight_of(x, u, t), b = flight_of(number(5), v, t);
        return said([&] { check.event({ball, 0, 1}, t, a, &b); });
    };
    CHECK(says(number(0), number(1), number(3), number(3)).empty());
    const char* laws = "laws of collision";
    CHECK(holds(says(number(1), number(0), number(3), number(3)), laws));                // on through each other
    CHECK(holds(says(number(1, 4), number(3, 4), number(3), number(3)), laws));          // energy lost
    CHECK(holds(says(number(0), number(-1), number(3), number(3)), laws));               // momentum lost
    CHECK(holds(says(number(0), number(1), number(301, 100), number(3)), laws));         // set down elsewhere
    CHECK(holds(says(number(0), number(1), number(2), number(2)), "do not touch"));      // too early
    CHECK(holds(says(number(0), number(1), number(4), number(4)), "inside each other")); // too late

    event_check<2> check(scene);
    const plane_flight a{ball_of(at(number(3), number(0)), at(number(0), number(0)), number(1)), number(3)};
    const plane_flight b{ball_of(at(number(5), number(0)), at(number(3, 5), number(4, 5)), number(1)), number(3)};
    CHECK(holds(said([&] { check.event({ball, 0, 1}, number(3), a, &b); }), laws)); // aside
}

TEST_CASE("what enclosures leave open is said to be open") {
    const auto scene = two_balls();
    event_check<2> check(scene);
    certified wide = sqrt(number(9)).rounded(3) * number(1000, 1001).rounded(3); // 3 to less than three bits
    const plane_flight a = flight_of(number(3), number(0), wide), b = flight_of(number(5), number(1), wide);
    CHECK(holds(said([&] { check.event({ball, 0, 1}, wide, a, &b); }), "open: where they meet"));
}

TEST_CASE("a point goes through no wall at the instant of an event") {
    // It comes to the place where the middle of wall 1 crosses wall 0, bounces off wall 0, and would then be on the
    // other side of wall 1.
    owned_scene<2, certified> s;
    s.balls.push_back(ball_of(at(number(-1), number(1)), at(number(1), number(-1)), number(0)));
    s.walls.push_back({at(number(-2), number(0)), {at(number(4), number(0))}});
    s.walls.push_back({at(number(0), number(-1)), {at(number(0), number(2))}});
    event_check<2> check(s);
    const plane_flight up{ball_of(at(number(0), number(0)), at(number(1), number(1)), number(0)), number(1)};
    CHECK(said([&] { check.event({wall, 0, 0}, number(1), up, nullptr); }).empty());
    CHECK(holds(said([&] { check.end(number(2)); }), "ball 0 and wall 1 met, which was not reported"));
    const plane_flight back{ball_of(at(number(0), number(0)), at(number(-1), number(1)), number(0)), number(1)};
    CHECK(said([&] { check.event({wall, 0, 1}, number(1), back, nullptr); }).empty());
    CHECK(said([&] { check.end(number(2)); }).empty());

    s.walls[1] = {at(number(0), number(-1)), {at(number(0), number(1))}}; // a T: wall 1 ends there
    event_check<2> other(s);
    CHECK(said([&] { other.event({wall, 0, 0}, number(1), up, nullptr); }).empty());
    CHECK(said([&] { other.end(number(2)); }).empty());
}

TEST_CASE("clearances of a wall in space") {
    const graze::wall<3, certified> w{{{number(0), number(0), number(0)}},
                                      {{{{number(4), number(0), number(0)}}, {{number(2), number(2), number(0)}}}}};
    const auto nearest = [&](int x, int y, int z) { return nearest_point<3>(w, {{number(x), number(y), number(z)}}); };
    const auto is = [](const graze::vec<3, certified>& p, const certified& x, const certified& y) {
        return (p[0] - x).certain_sign() == 0 && (p[1] - y).certain_sign() == 0 && p[2].certain_sign() == 0;
    };
    CHECK(is(nearest(3, 1, 7), number(3), number(1)));  // above
    CHECK(is(nearest(2, -5, 1), number(2), number(0))); // beside an edge
    CHECK(is(nearest(0, 2, 3), number(1), number(1)));  // beside the slanting one: on x = y
    CHECK(is(nearest(9, 9, 9), number(6), number(2)));  // a corner
    CHECK(is(nearest(-1, -1, 0), number(0), number(0)));
}

TEST_CASE("a triangle is passed over at an inner edge alone") {
    // It falls onto the slanted edge of a triangle, half its radius beside it, at t = 5 - sqrt(7/8).
    owned_scene<3, certified> s;
    s.balls.push_back(
        {{{number(9, 4), number(9, 4), number(5)}}, {{number(0), number(0), number(-1)}}, number(1), number(1)});
    s.triangles.push_back({{{number(0), number(0), number(0)}},
                           {{{{number(4), number(0), number(0)}}, {{number(0), number(4), number(0)}}}}});
    const auto at_the_end = [&](std::uint8_t inner) {
        s.inner_edges = {inner};
        event_check<3> check(s);
        return said([&] { check.end_of_all(); });
    };
    const char* passed = "ball 0 and triangle 0 met before that";
    CHECK(holds(at_the_end(0b000), passed));
    CHECK(holds(at_the_end(0b101), passed));
    CHECK(at_the_end(0b010).empty());
    s.balls[0].position = {{number(1), number(1), number(5)}}; // onto the face
    CHECK(holds(at_the_end(0b111), passed));
    s.balls[0].position = {{number(3), number(3), number(5)}}; // past the edge
    CHECK(at_the_end(0b000).empty());
    s.balls[0].position = {{number(1), number(-1, 2), number(5)}}; // onto edge 2
    CHECK(at_the_end(0b100).empty());
    CHECK(holds(at_the_end(0b011), passed));
    s.balls[0].position = {{number(1), number(1), number(5)}};
    s.balls[0].radius = number(0); // a point meets faces only
    CHECK(holds(at_the_end(0b111), passed));
}

TEST_CASE("clearances of a triangle") {
    const graze::triangle<certified> w{{{number(0), number(0), number(0)}},
                                       {{{{number(4), number(0), number(0)}}, {{number(0), number(4), number(0)}}}}};
    const auto nearest = [&](int x, int y, int z) { return nearest_point<3>(w, {{number(x), number(y), number(z)}}); };
    const auto is = [](const graze::vec<3, certified>& x, int a, int b) {
        return (x[0] - number(a)).certain_sign() == 0 && (x[1] - number(b)).certain_sign() == 0 &&
               x[2].certain_sign() == 0;
    };
    CHECK(is(nearest(1, 1, 3), 1, 1));   // above it
    CHECK(is(nearest(3, 3, 1), 2, 2));   // beside the slanting edge
    CHECK(is(nearest(1, -2, 5), 1, 0));  // beside another one
    CHECK(is(nearest(9, -1, 2), 4, 0));  // a corner
    CHECK(is(nearest(-1, -1, 0), 0, 0)); // and another one
}

} // namespace event_check_test
