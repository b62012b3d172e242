// The certified run against scenes that are solved by hand or by other means.
#include "run/certified_run.hpp"
#include "run/sequence.hpp"
#include "scene_reader.hpp"

#include <graze/run/run.hpp>

#include <boost/multiprecision/mpfr.hpp>
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace certified_run_test {

using namespace compare;
using namespace compare::run;

namespace {

exact_scene<2> scene_of(const std::string& text) {
    return std::get<exact_scene<2>>(read_scene_text(text, "test", number_input::exactly).scene);
}

exact_scene<2> scene_file_of(const std::string& name) {
    return std::get<exact_scene<2>>(read_scene(GRAZE_SCENES "/" + name + ".json", number_input::exactly).scene);
}

certified_result<2> proved(const exact_scene<2>& scene, const extent& how_far, int digits = 15, long most = 1L << 16U) {
    return certified_run<2>(scene, how_far, {digits, most}, progress_line(false));
}

bool is(const certified& x, const exact& value) { return (x - certified(value, 64)).certain_sign() == 0; }

bool contains(const certified& x, const exact& value) { return !(x - certified(value, 64)).certain_sign(); }

constexpr graze::partner ball = graze::partner::ball, plane = graze::partner::plane;

} // namespace

TEST_CASE("a scene that is solved by hand") {
    // Masses 3 and 1, radius 1. A ball of speed 1 hits one at rest at t = 3, which gives 1/2 and 3/2. The lighter ball
    // goes 4 to the plane and comes back with -3/2; the heavier one has come towards it meanwhile.
    const exact_scene<2> scene = scene_of(R"({"dimension": 2, "balls": [
        {"position": [0, 0], "velocity": [1, 0], "radius": 1, "mass": 3},
        {"position": [5, 0], "velocity": [0, 0], "radius": 1}], "planes": [{"point": [10, 0], "normal": [2, 0]}]})");
    const certified_result<2> found = proved(scene, {{}, 3});
    REQUIRE(found.events.size() == 3);
    CHECK(found.why == graze::ending::events);
    CHECK(found.events[0].who == graze::scene_pair{ball, 0, 1});
    CHECK(is(found.events[0].time, 3));
    CHECK(is(found.events[0].a.position[0], 3));
    CHECK(is(found.events[0].a.velocity[0], exact(1, 2)));
    CHECK(is(found.events[0].b->velocity[0], exact(3, 2)));
    CHECK(found.events[1].who == graze::scene_pair{plane, 1, 0});
    CHECK(is(found.events[1].time, 3 + exact(8, 3)));
    CHECK(is(found.events[1].a.velocity[0], exact(-3, 2)));
    // By then the heavier ball is at 3 + 4/3 and the lighter one at 9: a gap of 8/3, which closes at speed 2. The
    // centre of mass moves with (3/2 - 3/2)/4 = 0, so both turn round.
    CHECK(found.events[2].who == graze::scene_pair{ball, 0, 1});
    CHECK(is(found.events[2].time, 3 + exact(8, 3) + exact(4, 3)));
    CHECK(is(found.events[2].a.velocity[0], exact(-1, 2)));
    CHECK(is(found.events[2].b->velocity[0], exact(3, 2)));
    CHECK(found.events[2].a.position[0].is_rational());
}

TEST_CASE("equal times that are no rationals are found equal") {
    // A pair and its mirror image in the plane: D = 4 - 1 = 3, so both meet at 10 - √3. The balls that were hit then
    // reach the plane from both sides at equal times.
    const exact_scene<2> scene = scene_of(R"({"dimension": 2, "balls": [
        {"position": [0, 0], "velocity": [1, 0], "radius": 1}, {"position": [10, 1], "velocity": [0, 0], "radius": 1},
        {"position": [200, 50], "velocity": [-1, 0], "radius": 1},
        {"position": [190, 51], "velocity": [0, 0], "radius": 1}],
        "planes": [{"point": [100, 0], "normal": [1, 0]}]})");
    const certified_result<2> found = proved(scene, {{}, 4}, 15, 512);
    REQUIRE(found.events.size() == 4);
    CHECK(!found.events[0].tied);
    CHECK(found.events[1].tied);
    CHECK(!found.events[1].chosen);
    const certified before = certified(10) - found.events[0].time;
    CHECK(is(before * before, 3));
    CHECK(!found.events[2].tied);
    CHECK(found.events[3].tied);
    CHECK(found.events[3].who.with == plane);
    CHECK(found.problem.empty());
}

TEST_CASE("a graze of rationals is settled") {
    const auto passing = [](const char* y) {
        return scene_of(std::string(R"({"dimension": 2, "balls": [
        {"position": [0, ")") +
                        y + R"("], "velocity": [1, 0], "radius": "1/3"},
        {"position": [5, 0], "velocity": [0, 0], "radius": "2/3"}]})");
    };
    const auto grazed = proved(passing("1"), {{}, 5});
    REQUIRE(grazed.events.size() == 1);
    CHECK(is(grazed.events[0].time, 5));
    CHECK(is(grazed.events[0].a.velocity[0], 1));
    CHECK(proved(passing("0x1.0000000000000000000000000000001p0"), {{}, 5}).events.empty());
    CHECK(proved(passing("0x0.ffffffffffffffffffffffffffffffp0"), {{}, 5}).events.size() == 1);
}

TEST_CASE("the cradle passes on one ball's velocity at one instant") {
    const certified_result<2> found = proved(scene_file_of("newtons_cradle"), {{}, 12});
    REQUIRE(found.events.size() == 12);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(found.events[i].who == graze::scene_pair{ball, static_cast<int>(i), static_cast<int>(i) + 1});
        CHECK(is(found.events[i].time, exact(7, 10)));
        CHECK(found.events[i].tied == (i > 0));
    }
    CHECK(found.events[5].who == graze::scene_pair{plane, 5, 1});
    CHECK(is(found.balls[0].velocity[0], 1)); // it goes back where it came from
}

TEST_CASE("Galperin's billiard counts the digits of pi") {
    const certified_result<2> found = proved(scene_file_of("galperin"), {{}, 1000});
    CHECK(found.events.size() == 314);
    CHECK(found.why == graze::ending::exhausted);
}

namespace {

// Traces the photon independently, in 120 digits: the nearest circle ahead, again and again.
using real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<120>, boost::multiprecision::et_off>;
struct traced {
    std::vector<std::pair<int, int>> mirrors;
    real distance;
};
traced trace(int until) {
    traced result;
    real x = real(1) / 2, y = real(1) / 10, u = 1, v = 0, left = until;
    while (true) {
        real nearest = left;
        std::pair<int, int> mirror;
        bool met = false;
        for (int i = -12; i <= 12; ++i) {
            for (int j = -12; j <= 12; ++j) {
                const real dx = x - i, dy = y - j, along = dx * u + dy * v;
                const real root = along * along - (dx * dx + dy * dy - real(1) / 9);
                if (along < 0 && root > 0 && -along - sqrt(root) < nearest && -along - sqrt(root) > real(1) / 1000000) {
                    nearest = -along - sqrt(root);
                    mirror = {i, j};
                    met = true;
                }
            }
        }
        x += u * nearest;
        y += v * nearest;
        if (!met) {
            result.distance = sqrt(x * x + y * y);
            return result;
        }
        left -= nearest;
        result.mirrors.push_back(mirror);
        const real nx = 3 * (x - mirror.first), ny = 3 * (y - mirror.second), twice = 2 * (u * nx + v * ny);
        u -= twice * nx;
        v -= twice * ny;
    }
}

} // namespace

TEST_CASE("the photon of the hundred digits") {
    const exact_scene<2> scene = scene_file_of("photon");
    const certified_result<2> found = proved(scene, {exact(10), {}}, 105);
    CHECK(found.why == graze::ending::time);
    const auto& p = found.balls[0].position;
    const std::string text = decimal_text(sqrt(p[0] * p[0] + p[1] * p[1]), 100);
    CHECK(text.substr(0, 26) == "0.995262919443354160890311"); // the published digits
    const traced other = trace(10);
    CHECK(text == other.distance.str(100, std::ios::fixed));
    REQUIRE(found.events.size() == other.mirrors.size());
    CHECK(other.mirrors.size() == 14);
    for (std::size_t i = 0; i < other.mirrors.size(); ++i) {
        const graze::scene_pair who = found.events[i].who;
        const auto& mirror = scene.balls[static_cast<std::size_t>(who.a == 0 ? who.b : who.a)].shape.position;
        CHECK(mirror[0] == other.mirrors[i].first);
        CHECK(mirror[1] == other.mirrors[i].second);
    }
}

TEST_CASE("forward, velocities turned round, and back: the start, certified") {
    using mechanics = certified_mechanics<2>;
    const exact_scene<2> scene = scene_file_of("photon");
    std::vector<graze::ball<2, certified>> balls;
    const certified infinite = certified::infinity();
    constexpr long bits = 400;
    for (const exact_ball<2>& b : scene.balls) {
        const auto in = [](const graze::vec<2, exact>& x) {
            return graze::vec<2, certified>{{certified(x[0], bits), certified(x[1], bits)}};
        };
        balls.push_back({in(b.shape.position), in(b.shape.velocity), certified(b.shape.radius, bits),
                         b.inverse_mass.is_zero() ? infinite : certified(1)});
    }
    graze::run<mechanics> there_and_back(graze::scene<2, certified>{balls, {}, {}});
    std::vector<graze::scene_pair> there, back;
    graze::run_limits<certified> limits;
    limits.time = certified(10);
    there_and_back.advance(limits, [&](const auto& e) { there.push_back(e.who); });
    there_and_back.restate([&](int, const mechanics::state& s) {
        if (s.state.mass.is_infinite()) {
            return s;
        }
        mechanics::state turned{there_and_back.rules().ball_at(s, certified(10)), certified(10)};
        turned.state.velocity = -turned.state.velocity;
        return turned;
    });
    limits.time = certified(20);
    there_and_back.advance(limits, [&](const auto& e) { back.push_back(e.who); });
    CHECK(there.size() == 14);
    CHECK(std::vector<graze::scene_pair>(back.rbegin(), back.rend()) == there);
    const graze::ball<2, certified> home = there_and_back.rules().ball_at(there_and_back.in_flight(0), certified(20));
    CHECK(contains(home.position[0], exact(1, 2)));
    CHECK(contains(home.position[1], exact(1, 10)));
    CHECK(contains(home.velocity[0], -1));
    CHECK(contains(home.velocity[1], 0));
    for (int i = 0; i < 2; ++i) {
        CHECK(decimals_of(home.position[i]) > 80);
        CHECK(decimals_of(home.velocity[i]) > 80);
    }
}

TEST_CASE("digits and decimals") {
    CHECK(decimal_text(certified(exact(2, 3), 10), 5) == "0.66667");
    CHECK(decimal_text(certified(exact(-1, 8), 10), 2) == "-0.12");
    CHECK(decimal_text(certified(0), 3) == "0.000");
    CHECK(decimal_text(sqrt(certified(exact(2), 10)), 30) == "1.414213562373095048801688724210"); // exact
    const certified root = sqrt(certified(exact(2), 200)).enclosed();
    const long decimals = decimals_of(root);
    CHECK(decimals > 55);
    CHECK(decimals < 62);
    CHECK(decimal_text(root, 50) == "1.41421356237309504880168872420969807856967187537695");
}

TEST_CASE("the first mistake of a run") {
    certified_result<2> truth;
    truth.why = graze::ending::events;
    const graze::scene_pair a{ball, 0, 1}, b{ball, 1, 2}, c{plane, 2, 0}, d{plane, 0, 0};
    for (const graze::scene_pair& who : {a, b, c}) {
        truth.events.push_back(
            {who, certified(static_cast<int>(truth.events.size()) + 1), false, false, false, {}, {}});
    }
    const auto mistake_of = [&](std::vector<graze::scene_pair> events) {
        history h;
        while (h.digits.size() < events.size() && h.digits.size() < 3 &&
               events[h.digits.size()] == truth.events[h.digits.size()].who) {
            h.digits.push_back(10);
        }
        h.times.assign(events.size(), 5);
        h.events = std::move(events);
        return first_mistake_of<2>(h, truth);
    };
    CHECK(mistake_of({a, b, c}).what == mistake::none);
    CHECK(mistake_of({a, c}).what == mistake::missed);
    CHECK(mistake_of({a, c}).text == "ball 1 and ball 2 is missed");
    CHECK(mistake_of({a, b}).what == mistake::missed);
    CHECK(mistake_of({a, d, b, c}).what == mistake::invented);
    CHECK(mistake_of({a, b, c, d}).what == mistake::invented);
    CHECK(mistake_of({a, c, b}).what == mistake::out_of_order);
    CHECK(mistake_of({a, d}).what == mistake::other);
    CHECK(mistake_of({a, d}).at == 1);
}

TEST_CASE("nothing is said of what was not run, or is not known") {
    certified_result<2> truth;
    truth.why = graze::ending::events;
    const graze::scene_pair a{ball, 0, 1}, b{ball, 1, 2}, c{plane, 2, 0}, d{plane, 0, 0};
    for (const graze::scene_pair& who : {a, b, c}) {
        truth.events.push_back(
            {who, certified(static_cast<int>(truth.events.size()) + 1), false, false, false, {}, {}});
    }
    history h;
    h.events = {a};
    h.times = {1};
    h.digits = {10};
    h.compared = comparison::part;
    CHECK(first_mistake_of<2>(h, truth).what == mistake::none);
    h.events = {a, c}; // b may have come after the interruption
    h.times = {1, 3};
    CHECK(first_mistake_of<2>(h, truth).what == mistake::out_of_order);
    h.events = {a, d};
    CHECK(first_mistake_of<2>(h, truth).what == mistake::invented);
    h = {};
    h.compared = comparison::none;
    CHECK(first_mistake_of<2>(h, truth).what == mistake::none);

    // The proof was interrupted, and the type went on.
    h.compared = comparison::whole;
    h.events = {a, b, c, d};
    h.times = {1, 2, 3, 4};
    h.digits = {10, 10, 10};
    truth.why = graze::ending::stopped;
    CHECK(first_mistake_of<2>(h, truth).what == mistake::none);
    truth.why = graze::ending::events;
    CHECK(first_mistake_of<2>(h, truth).what == mistake::invented);
}

TEST_CASE("images are met in a scene that has a period") {
    // Two balls on a line of length 4, which meet at 0 and at 2 in turn.
    const certified_result<2> line = proved(scene_of(R"({"dimension": 2, "period": [4, 0], "balls": [
        {"position": [-1, 0], "velocity": [1, 0], "radius": "1/2"},
        {"position": [9, 0], "velocity": [-1, 0], "radius": "1/2"}]})"),
                                            {{}, 5});
    CHECK(line.problem == "");
    REQUIRE(line.events.size() == 5);
    for (int i = 0; i < 5; ++i) {
        CHECK(is(line.events[static_cast<std::size_t>(i)].time, exact(2 * i + 1, 2)));
    }
    // The events do not depend on which images are given, nor on how the balls meet.
    const auto oblique = [](const char* third) {
        return proved(scene_of(std::string(R"({"dimension": 2, "period": [5, "9/2"], "balls": [
            {"position": [0, 0], "velocity": [1, "1/3"], "radius": "1/2"},
            {"position": [2, 1], "velocity": ["-1/7", 1], "radius": "3/4"},
            {"position": )") + third +
                               R"(, "velocity": [0, "-2/3"], "radius": 1}]})"),
                      {{}, 8});
    };
    const certified_result<2> found = oblique(R"([-2, "-3/2"])"), other = oblique(R"([13, "-21/2"])");
    CHECK(found.problem == "");
    REQUIRE(found.events.size() == 8);
    REQUIRE(other.events.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(found.events[i].who == other.events[i].who);
        CHECK(!(found.events[i].time - other.events[i].time).certain_sign().value_or(0));
    }
}

namespace {

// Three balls in a cuboid whose six sides are walls, or pairs of triangles with a common inner edge.
exact_scene<3> cuboid(bool of_triangles) {
    const std::string balls = R"("balls": [
        {"position": [1, 1, 1], "velocity": [1, "1/3", "2/7"], "radius": "1/2"},
        {"position": [4, 3, 2], "velocity": ["-2/3", "1/5", "3/4"], "radius": "3/4", "mass": 2},
        {"position": [3, 1, 4], "velocity": ["1/9", "5/4", "-1/2"], "radius": "1/3"}], )";
    const char* sides[6][3] = {{"[0, 0, 0]", "[6, 0, 0]", "[0, 5, 0]"}, {"[0, 0, 5]", "[6, 0, 0]", "[0, 5, 0]"},
                               {"[0, 0, 0]", "[6, 0, 0]", "[0, 0, 5]"}, {"[0, 5, 0]", "[6, 0, 0]", "[0, 0, 5]"},
                               {"[0, 0, 0]", "[0, 5, 0]", "[0, 0, 5]"}, {"[6, 0, 0]", "[0, 5, 0]", "[0, 0, 5]"}};
    const char* far_corners[6] = {"[6, 5, 0]", "[6, 5, 5]", "[6, 0, 5]", "[6, 5, 5]", "[0, 5, 5]", "[6, 5, 5]"};
    const auto turned = [](std::string edge) { // all of a side's edges lead away from 0
        const auto at = edge.find_first_of("56");
        return edge.insert(at, "-");
    };
    std::string flats;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto flat = [&](const std::string& corner, const std::string& e, const std::string& f) {
            flats += (flats.empty() ? "" : ", ") + (R"({"corner": )" + corner) + R"(, "edges": [)" + e + ", " + f +
                     (of_triangles ? R"(], "inner_edges": [1]})" : "]}");
        };
        flat(sides[i][0], sides[i][1], sides[i][2]);
        if (of_triangles) {
            flat(far_corners[i], turned(sides[i][1]), turned(sides[i][2]));
        }
    }
    const std::string text =
        R"({"dimension": 3, )" + balls + (of_triangles ? R"("triangles": [)" : R"("walls": [)") + flats + "]}";
    return std::get<exact_scene<3>>(read_scene_text(text, "test", number_input::exactly).scene);
}

} // namespace

TEST_CASE("two triangles that share an inner edge are what the wall is that they cover") {
    const auto run = [](bool of_triangles) {
        return certified_run<3>(cuboid(of_triangles), {{}, 24}, {15, 1L << 12U}, progress_line(false));
    };
    const certified_result<3> walls = run(false), triangles = run(true);
    CHECK(walls.problem == "");
    CHECK(triangles.problem == "");
    REQUIRE(walls.events.size() == 24);
    REQUIRE(triangles.events.size() == 24);
    for (std::size_t i = 0; i < 24; ++i) {
        graze::scene_pair who = triangles.events[i].who;
        if (who.with == graze::partner::triangle) {
            who = {graze::partner::wall, who.a, who.b / 2};
        }
        CHECK(who == walls.events[i].who);
        CHECK(!(triangles.events[i].time - walls.events[i].time).certain_sign().value_or(0));
    }
}

TEST_CASE("a certified ball meets a triangle's slanted edge and its corners") {
    // Balls fall onto the edge from (4, 0, 0) to (0, 4, 0) at a distance of r/2 from it, onto a corner, and past the
    // edge.
    const auto fall = [](const char* x, const char* inner) {
        const std::string text = std::string(R"({"dimension": 3, "balls": [{"position": )") + x +
                                 R"(, "velocity": [0, 0, -1], "radius": 1}],
            "triangles": [{"corner": [0, 0, 0], "edges": [[4, 0, 0], [0, 4, 0]], "inner_edges": )" +
                                 inner + "}]}";
        return certified_run<3>(std::get<exact_scene<3>>(read_scene_text(text, "test", number_input::exactly).scene),
                                {{}, 4}, {15, 1L << 10U}, progress_line(false));
    };
    const auto edge = fall(R"(["9/4", "9/4", 5])", "[]"); // (x + y - 4)^2/2 = 1/8 from it: at a height of sqrt(7/8)
    REQUIRE(edge.events.size() == 1);
    CHECK(edge.problem == "");
    CHECK(near_double(edge.events[0].time) == doctest::Approx(5 - std::sqrt(7 / 8.)).epsilon(1e-15));
    const auto corner = fall(R"(["9/2", "-1/4", 5])", "[]"); // 5/16 from (4, 0, 0)
    REQUIRE(corner.events.size() == 1);
    CHECK(near_double(corner.events[0].time) == doctest::Approx(5 - std::sqrt(11 / 16.)).epsilon(1e-15));
    CHECK(fall(R"([3, 3, 5])", "[]").events.empty());
    for (const auto& passed : {fall(R"(["9/4", "9/4", 5])", "[1]"), fall(R"(["9/2", "-1/4", 5])", "[1]")}) {
        CHECK(passed.problem == ""); // and the check refutes nothing
        CHECK(passed.events.empty());
    }
    CHECK(fall(R"(["9/4", "9/4", 5])", "[0, 2]").events.size() == 1);
    CHECK(fall(R"([1, 1, 5])", "[0, 1, 2]").events.size() == 1); // the face is met all the same
}

} // namespace certified_run_test
