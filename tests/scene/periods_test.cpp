// Periodic scenes: every ball meets the images of the others, whichever image was given.
#include "../property.hpp"
#include "fraction.hpp"

#include <graze/contact/collide_images.hpp>
#include <graze/number/floating.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace periods_test {

namespace {

using plain = graze::plain_mechanics<2, double>;

struct box {
    std::vector<graze::ball<2>> balls;
    std::vector<graze::plane<2>> planes;
    graze::vec<2, double> period;

    [[nodiscard]] graze::scene<2> scene() const { return {balls, planes, {}, period}; }
};

// In multiples of 2^-20, so that whole periods can be added exactly. slit: between two planes.
box any_box(bool slit, bool dense = true) {
    std::mt19937_64 random(property::any<std::uint64_t>());
    const auto below = [&](double most) {
        return std::ldexp(std::floor(most * std::ldexp(double(random() >> 44), 0)), -20);
    };
    box b;
    b.period = {{property::one_of(2.5, 4.0, 9.25), slit ? 0 : property::one_of(2.25, 5.0, 8.0)}};
    const double height = slit ? 5 : b.period[1];
    const int count = property::in_range(1, dense ? 30 : 6);
    for (int tries = 0; tries < 300 && static_cast<int>(b.balls.size()) < count; ++tries) {
        graze::ball<2> x{};
        x.radius = property::one_of(0.25, 0.5, 1.0);
        x.position = {{below(b.period[0]), slit ? x.radius + below(height - 2 * x.radius) : below(height)}};
        x.velocity = {{below(2) - 1, below(2) - 1}};
        x.mass = 1 + below(1);
        const auto apart = [&](const auto& y) {
            double least = 1e9;
            for (int i = -1; i <= 1; ++i) {
                for (int j = -1; j <= 1; ++j) {
                    const graze::vec<2, double> d = {{x.position[0] - y.position[0] + i * b.period[0],
                                                      x.position[1] - y.position[1] + j * b.period[1]}};
                    least = std::min(least, graze::squared_norm(d));
                }
            }
            return std::sqrt(least) > x.radius + y.radius;
        };
        if (2 * x.radius < b.period[0] && (slit || 2 * x.radius < b.period[1]) &&
            std::all_of(b.balls.begin(), b.balls.end(), apart)) {
            b.balls.push_back(x);
        }
    }
    if (slit) {
        b.planes = {{{{0, 0}}, {{0, 2}}}, {{{3, height}}, {{0, -1}}}};
    }
    return b;
}

struct told_event {
    graze::scene_pair who;
    double time;
    graze::vec<2, double> position, velocity;
    bool operator==(const told_event& e) const {
        return who == e.who && time == e.time && position == e.position && velocity == e.velocity;
    }
};
std::vector<told_event> told(const box& b, graze::cells use = graze::cells::where_useful) {
    std::vector<told_event> events;
    graze::run<plain> run(b.scene(), {}, use);
    run.advance({.time = 20.0, .events = 150}, [&](const graze::run_event<plain>& e) {
        events.push_back({e.who, e.when, e.after_a.state.position, e.after_a.state.velocity});
    });
    return events;
}

std::string fault_of(const graze::scene<2>& s) {
    try {
        check(s);
    } catch (const std::domain_error& e) {
        return e.what();
    }
    return "";
}

} // namespace

TEST_CASE("what does not fit into a period is named") {
    const std::vector<graze::ball<2>> balls = {{{{0, 0}}, {{1, 0}}, 0.5, 1}, {{{3, 0}}, {{1, 0}}, 1, 1}};
    const std::vector<graze::plane<2>> level = {{{{0, -4}}, {{0, 1}}}},
                                       upright = {{{{0, -4}}, {{0, 1}}}, {{{0, 0}}, {{1, 9}}}};
    const std::vector<graze::wall<2>> wide = {{{{0, 0}}, {{{{-4.5, 1}}}}}};
    CHECK(fault_of({balls, level, {}, {{4, 0}}}) == "");
    CHECK(fault_of({balls, level, {}, {{2, 0}}}) == "ball 1: diameter reaches the period");
    CHECK(fault_of({balls, upright, {}, {{4, 0}}}) == "plane 1: normal has a component along a period");
    CHECK(fault_of({balls, {}, wide, {{4, 0}}}) == "wall 0: longer than the period");
    CHECK(fault_of({balls, {}, wide, {{5, 0}}}) == "");
    CHECK(fault_of({balls, {}, {}, {{-4, 0}}}) == "period: not a finite number from 0 on");
    CHECK(fault_of({balls, {}, {}, {{std::nan(""), 0}}}) == "period: not a finite number from 0 on");
}

TEST_CASE("two balls on a line meet at both sides, each image in its turn") {
    const std::vector<graze::ball<2>> two = {{{{-1, 0}}, {{1, 0}}, 0.5, 1}, {{{1, 0}}, {{-1, 0}}, 0.5, 1}};
    graze::run<plain> run(graze::scene<2>{two, {}, {}, {{4, 0}}});
    std::vector<double> times;
    CHECK(run.advance({.events = 6}, [&](const auto& e) { times.push_back(e.when); }).events == 6);
    CHECK(times == std::vector<double>{0.5, 1.5, 2.5, 3.5, 4.5, 5.5}); // at 0 and at 2
}

TEST_CASE("a ball that is alone meets nobody, not itself either") {
    const std::vector<graze::ball<2>> one = {{{{0, 0}}, {{3, 1}}, 0.5, 1}};
    graze::run<plain> run(graze::scene<2>{one, {}, {}, {{1.5, 1.25}}});
    const auto done = run.advance({.time = 50.0});
    CHECK(done.events == 0);
    CHECK(done.why == graze::ending::time);
}

TEST_CASE("a ball comes from hundreds of periods away to where its flight leads") {
    // The real position of the one that doubles leave open is rounded in integers.
    constexpr double length = 0x1.21cc83d1999dbp-2;
    const graze::flight<2> a{
        {{{-0x1.7f444p-4, 0x1.2ddc8p-3}}, {{0x1.33ff28p+31, -0x1.9aa74p+19}}, 0x1.1da54bb937bcbp-5}, 0};
    const graze::flight<2> b{{{{0x1.5142p-6, 0x1.25cap-7}}, {{-0x1.5723bp+5, 0x1.0e2dep+3}}, 0x1.e318bf9c749ddp-7}, 0};
    const auto c = graze::detail::collide_image(a, b, graze::image_shift<2, double>{{964, 0, 0}, {{length, 0}}});
    REQUIRE(c);
    for (int i = 0; i < 2; ++i) {
        const double way = a.state.velocity[i] * c->time;
        CHECK(std::fabs(a.state.position[i] + way - c->position_a[i]) <= 0x1p-48 * std::fabs(way));
        CHECK(std::fabs(b.state.position[i] + b.state.velocity[i] * c->time - c->position_b[i]) <= 0x1p-48);
    }
}

TEST_CASE("balls that all fly alike never meet, and where nothing happens for long a run asks whether to go on") {
    const std::vector<graze::ball<2>> alike = {{{{0, 0}}, {{3, 1}}, 0.5, 1}, {{{2, 1}}, {{3, 1}}, 0.5, 1}};
    graze::run<plain> run(graze::scene<2>{.balls = alike, .period = {{5, 5}}});
    CHECK(run.advance({}).why == graze::ending::exhausted);
    const std::vector<graze::ball<2>> aside = {{{{0, 0}}, {{3, 0}}, 0.5, 1}, {{{2, 1.5}}, {{2, 0}}, 0.5, 1}};
    graze::run<plain> apart(graze::scene<2>{.balls = aside, .period = {{5, 5}}});
    CHECK(apart.advance({}).why == graze::ending::idle);
    CHECK(apart.advance({.time = 1e4}).why == graze::ending::time);
}

TEST_CASE("a wall is met in every period") {
    const std::vector<graze::ball<2>> one = {{{{1, 0}}, {{1, 0}}, 0.25, 1}};
    const std::vector<graze::wall<2>> upright = {{{{11, -1}}, {{{{0, 2}}}}}}; // at 3, 7, -1
    graze::run<plain> run(graze::scene<2>{one, {}, upright, {{4, 0}}});
    std::vector<double> times;
    run.advance({.events = 3}, [&](const auto& e) { times.push_back(e.when); });
    CHECK(times == std::vector<double>{1.75, 5.25, 8.75});
}

TEST_CASE("cells have no part, nor has the period in which a ball is given; positions stay within half of one") {
    std::size_t events = 0;
    CHECK(property::check([&] {
        const bool slit = property::any<bool>();
        const box b = any_box(slit);
        const auto expected = told(b);
        events += expected.size();
        PROPERTY_ASSERT(told(b, graze::cells::none) == expected);
        box moved = b;
        for (auto& x : moved.balls) {
            for (int i = 0; i < 2; ++i) {
                x.position[i] += property::in_range(-5, 6) * b.period[i];
            }
        }
        PROPERTY_ASSERT(told(moved) == expected);
        for (const auto& e : expected) {
            for (int i = 0; i < 2; ++i) {
                PROPERTY_ASSERT(b.period[i] == 0 || std::fabs(e.position[i]) <= b.period[i] / 2);
            }
        }
    }));
    CHECK(events > 100);
}

TEST_CASE("in exact numbers the run is that of copies, to the last digit") {
    using exact = graze::plain_mechanics<2, fraction>;
    std::size_t total = 0;
    CHECK(property::check([&] {
        // Eight balls with rational places and speeds on two lines. They meet head-on, so everything stays rational.
        const int most = 15;
        std::mt19937_64 random(property::any<std::uint64_t>());
        const auto below = [&](int end) { return fraction(static_cast<int>(random() % static_cast<unsigned>(end))); };
        const fraction length = fraction(13) + below(8);
        std::vector<graze::ball<2, fraction>> balls;
        for (int i = 0; i < 8; ++i) {
            const fraction place = fraction(3 * (i / 2)) + below(900) / fraction(997);
            balls.push_back({{{place, fraction(i % 2 * 4)}},
                             {{below(81) - fraction(40), fraction(0)}},
                             fraction(1),
                             fraction(1) + below(3)});
        }
        std::vector<std::pair<fraction, graze::scene_pair>> expected, found;
        const auto name = [](int a, int b) {
            return graze::scene_pair{graze::partner::ball, std::min(a, b), std::max(a, b)};
        };
        graze::run<exact> periodic(graze::scene<2, fraction>{.balls = balls, .period = {{length, fraction(9)}}});
        periodic.advance({.events = static_cast<std::uint64_t>(most)}, [&](const graze::run_event<exact>& e) {
            expected.emplace_back(e.when, name(e.who.a, e.who.b));
        });
        if (expected.empty()) {
            return;
        }
        // The lack of neighbours beyond the outermost copies affects at most one more copy with each event.
        std::vector<graze::ball<2, fraction>> copies;
        for (int k = -most - 1; k <= most + 1; ++k) {
            for (auto b : balls) {
                b.position[0] = b.position[0] + fraction(k) * length;
                copies.push_back(b);
            }
        }
        graze::run<exact> many(graze::scene<2, fraction>{.balls = copies});
        many.advance({.time = expected.back().first}, [&](const graze::run_event<exact>& e) {
            const int first = e.who.a % 8 < e.who.b % 8 ? e.who.a : e.who.b; // which is in one copy alone
            if (first / 8 == most + 1) {
                found.emplace_back(e.when, name(e.who.a % 8, e.who.b % 8));
            }
        });
        PROPERTY_ASSERT(found == expected);
        total += expected.size();
    }));
    CHECK(total > 100);
}

} // namespace periods_test
