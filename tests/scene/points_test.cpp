// A point among walls in runs, compared with an oracle in rationals and with small balls; and what was once wrong.
#include "../property.hpp"
#include "point_checks.hpp"
#include "point_images.hpp"
#include "sliding_scenes.hpp"

#include <doctest/doctest.h>

namespace {

template <int N, bool Slanted>
void compare_scenes() {
    std::size_t by_oracle = 0, by_balls = 0;
    CHECK(property::check([&] {
        const auto seed = property::in_range<std::uint64_t>(0, std::uint64_t{1} << 48);
        const auto s = any_point_scene<N>(seed, Slanted);
        property::log("any_point_scene<" + std::to_string(N) + ">(" + std::to_string(seed) +
                      (Slanted ? ", true)" : ", false)"));
        PROPERTY_ASSERT(fault_by_oracle<N>(s, 12, &by_oracle) == "");
        PROPERTY_ASSERT(fault_beside_balls<N>(s, 12, &by_balls) == "");
    }));
    CHECK(by_oracle > 40);
    CHECK(by_balls > 40);
}

// The walls met at each time, with the last velocity.
std::vector<std::size_t> met_by(const point_scene<2>& s) {
    std::vector<std::size_t> result;
    for (const told_bounce& b : bounces_of<2>(s, 1000)) {
        result.push_back(b.wall);
    }
    return result;
}
graze::vec<3, double> last_velocity(const point_scene<2>& s) { return bounces_of<2>(s, 1000).back().velocity; }

using walls = std::vector<std::size_t>;

} // namespace

TEST_CASE("a point meets what the oracle says, and what balls beside it meet") {
    compare_scenes<2, false>();
    compare_scenes<2, true>();
    compare_scenes<3, false>();
    compare_scenes<3, true>();
}

TEST_CASE("in a space with a period a point meets images as it meets copies") {
    std::size_t compared = 0;
    const auto compare = [&](auto scene_of, int dimension) {
        for (std::uint64_t seed = 0; seed < 36; ++seed) {
            const double length = std::array{4.0, 6.0, 8.0, 16.0}[seed / 2 % 4];
            INFO(dimension, " ", seed);
            CHECK(fault_beside_copies(scene_of(seed), static_cast<int>(seed) % dimension, length, &compared) == "");
        }
    };
    compare([](std::uint64_t seed) { return any_point_scene<2>(seed, false); }, 2);
    compare([](std::uint64_t seed) { return any_point_scene<2>(seed, true); }, 2);
    compare([](std::uint64_t seed) { return any_point_scene<3>(seed, false); }, 3);
    CHECK(compared > 25);
}

TEST_CASE("a point keeps its side of an image, though rounding carries it beyond") {
    // It slides along a floor of tiles, bounces off a ball there and comes back; it never falls through a seam.
    const std::vector<graze::ball<2>> balls = {{{{0.3, 0.7}}, {{0.3, -1.1}}, 0, 1},
                                               {{{1.1, 0.4}}, {{0.2, 0.3}}, 0.25, 3}};
    const std::vector<graze::wall<2>> walls = {
        {{{-0.5, -0.75}}, {{{{1, 0}}}}}, {{{0.5, -0.75}}, {{{{1, 0}}}}}, {{{-0.5, 0.75}}, {{{{2, 0}}}}}};
    std::size_t events = 0;
    (void)run_exactly<2>({.balls = balls, .walls = walls, .period = {{2, 0}}}, {.events = 2000}, [&](const auto& e) {
        for (const auto* f : {&e.after_a, e.after_b}) {
            events += f != nullptr && std::fabs(f->state.position[1]) <= 0.75 && std::fabs(f->state.position[0]) <= 1;
        }
        return true;
    });
    CHECK(events > 2000);
}

TEST_CASE("a point is not turned back by the tip of a wall beside which it has come") {
    // Found by the soak: the point's position rounds to exactly that tip.
    CHECK(fault_beside_balls<2>(any_point_scene<2>(2'012'954, true), 12, nullptr) == "");
}

TEST_CASE("at a T-junction a point bounces off the floor alone, as its neighbours do") {
    for (const double x : {0.0, 0x1p-20, -0x1p-20}) {
        const point_scene<2> s{{{{{x, 1}}, {{1, -1}}, 0, 1}}, {{{{0, 0}}, {{{{2, 0}}}}}, {{{1, 0}}, {{{{0, -1}}}}}}};
        CHECK(met_by(s) == walls{0});
        CHECK(last_velocity(s) == graze::vec<3, double>{{1, 1, 0}});
    }
}

TEST_CASE("a point does not meet a wall on whose line it is") {
    const point_scene<2> s{{{{{0, 1}}, {{0, -1}}, 0, 1}},
                           {{{{-1, -1}}, {{{{1, 1}}}}}, {{{0, 0}}, {{{{1, 0}}}}}, {{{-6, -1}}, {{{{2, 2}}}}}}};
    CHECK(met_by(s) == walls{0, 2});
    CHECK(last_velocity(s) == graze::vec<3, double>{{0, -1, 0}});
}

TEST_CASE("a point bounces once at an outward tip, however sharp") {
    for (const double length : {1.0, 4.0, 100.0}) {
        for (const double lower : {-1.0, 0.0}) {
            const point_scene<2> s{{{{{-1, 0}}, {{1, 0}}, 0, 1}},
                                   {{{{0, 0}}, {{{{length, 1}}}}}, {{{0, 0}}, {{{{length, lower}}}}}}};
            const auto told = bounces_of<2>(s, 1000); // one wall along the way is grazed
            CHECK(std::ranges::count_if(told, &told_bounce::turned) == 1);
        }
    }
}

TEST_CASE("a point that has come to slide above a floor stays above it") {
    for (const point_scene<2>& s : sliding_scenes()) {
        CHECK(fault_by_oracle<2>(s, 20, nullptr) == "");
        CHECK(fault_by_oracle<3>(raised(s), 20, nullptr) == "");
        auto told = bounces_of<2>(s, 20);
        std::erase_if(told, [](const told_bounce& b) { return !b.turned; });
        CHECK(told.front().wall == 0);
        CHECK(told.front().velocity[1] == 0);
        if (std::abs(s.walls[1].edge[0][1]) == 1) { // that wall hangs and is not reached
            CHECK(told.size() == 1);
        } else { // down, up, and back the way it came
            REQUIRE(told.size() == 5);
            CHECK(told[1].wall == 1);
            CHECK(told[2].wall >= 2);
            CHECK(told[3].wall == 1);
            CHECK(told[4].wall == 0);
            CHECK(told[4].velocity == graze::vec<3, double>{{0, 1, 0}});
        }
    }
}

// A point turns at a slanted wall and goes up the edge where two walls meet, to a third wall across that edge.
TEST_CASE("a point that slides along two walls stays in the corner between them") {
    for (const double x : {1.0, -1.0}) {
        for (const double y : {1.0, -1.0}) {
            point_scene<3> s;
            s.point.push_back({{{4, 2, -4}}, {{-2, -1, 2}}, 0, 1});
            s.walls = {{{{-2, 2, 2}}, {{{{2, -4, 0}}, {{2, 0, -4}}}}}, // across (2, 1, 1)
                       {{{0, 0, 0}}, {{{{8, 0, 0}}, {{0, 0, 8}}}}},
                       {{{0, 0, 0}}, {{{{0, 8, 0}}, {{0, 0, 8}}}}},
                       {{{-2, -2, 3 - 2 * x - 2 * y}}, {{{{4, 0, 4 * x}}, {{0, 4, 4 * y}}}}}}; // across (x, y, -1)
            std::size_t compared = 0;
            CHECK(fault_by_oracle<3>(s, 20, &compared) == "");
            CHECK(compared >= 2);
            const auto told = bounces_of<3>(s, 20);
            REQUIRE(told.size() >= 2);
            CHECK(told[0].velocity == graze::vec<3, double>{{0, 0, 3}});
            CHECK(told.back().velocity[0] > 0);
            CHECK(told.back().velocity[1] > 0);
        }
    }
}

TEST_CASE("a point comes out of a wedge of walls on the side from which it came") {
    const point_scene<2> s{{{{{8, 1}}, {{-8, -1}}, 0, 1}}, {{{{0, 0}}, {{{{9, 0}}}}}, {{{0, 0}}, {{{{8, 2}}}}}}};
    CHECK(met_by(s).size() == 13); // as in the straightened picture
    CHECK(last_velocity(s)[1] > 0);
    CHECK(last_velocity(s)[0] > 4 * last_velocity(s)[1]);
}

TEST_CASE("a point that is given its own or the opposite velocity in a corner stays on its side of both walls") {
    const std::vector<graze::ball<2>> point{{{{1, 1}}, {{-1, -1}}, 0, 1}};
    const std::vector<graze::wall<2>> walls{{{{0, 0}}, {{{{0, 4}}}}}, {{{0, 0}}, {{{{4, 0}}}}}};
    for (const double sense : {1.0, -1.0}) {
        graze::run<graze::exact_mechanics<2>> run(graze::scene<2>{point, {}, walls});
        REQUIRE(run.advance({.events = 1}).events == 1);
        run.restate([&](std::size_t, auto state) {
            state.state.velocity = sense * state.state.velocity;
            return state;
        });
        CHECK(run.advance({.events = 9}).events == 1);
        CHECK(run.in_flight(0).state.velocity == graze::vec<2, double>{{1, 1}});
    }
}

// Its height is rounded to that of the floor beside the seam that it really meets.
TEST_CASE("a point that a wall turns back above the seam of two floors meets the floor") {
    const std::vector<graze::ball<3>> point{
        {{{-2.3333333333333335, 3.666666666666667, 11.666666666666666}}, {{4, 4, 4}}, 0, 1}};
    const graze::wall<3> wall{{{-6, 8, 10}}, {{{{16, 0, 0}}, {{0, 0, 8}}}}};
    const point_scene<3> whole{point, {wall, {{{-6, 0, 16}}, {{{{16, 0, 0}}, {{0, 8, 0}}}}}}};
    const point_scene<3> halves{
        point, {wall, {{{-6, 0, 16}}, {{{{8, 0, 0}}, {{0, 8, 0}}}}}, {{{2, 0, 16}}, {{{{8, 0, 0}}, {{0, 8, 0}}}}}}};
    CHECK(bounces_of<3>(whole, 9).back().velocity[2] == -4);
    CHECK(bounces_of<3>(halves, 9).back().velocity[2] == -4);
}

TEST_CASE("a point does not leave a box of slanted walls, aimed at its corners too") {
    CHECK(property::check([] {
        // Corners at ±(p, q) and ±(q, -p) times 2^-4; its sides are exact, points on them are not.
        const double p = property::in_range(1, 99) * 0x1p-4, q = property::in_range(1, 99) * 0x1p-4;
        const std::array<graze::vec<2, double>, 4> corners{{{{p, q}}, {{-q, p}}, {{-p, -q}}, {{q, -p}}}};
        point_scene<2> s;
        for (std::size_t i = 0; i < 4; ++i) {
            s.walls.push_back({corners[i], {{corners[(i + 1) % 4] - corners[i]}}});
        }
        const auto& aim = corners[property::in_range<std::size_t>(0, 4)];
        const double speed = property::in_range(1, 99) * 0.01;
        s.point.push_back({{{0, 0}}, speed * aim, 0, 1});
        const auto finished = run_exactly<2>({s.point, {}, s.walls}, {.events = 60});
        PROPERTY_ASSERT(finished.outcome.why == graze::ending::events);
        PROPERTY_ASSERT(graze::squared_norm(finished.flights[0].state.position) < 1.01 * (p * p + q * q));
    }));
}
