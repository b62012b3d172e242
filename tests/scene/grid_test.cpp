// The cells decide which pairs are predicted, never what happens; and a run continues after an interruption as if there
// had been none.
#include "../property.hpp"

#include <graze/number/floating.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace grid_test {

namespace {

template <int N>
struct parts_of_scene {
    std::vector<graze::ball<N>> balls;
    std::vector<graze::plane<N>> planes;

    [[nodiscard]] graze::scene<N> scene() const { return {balls, planes, {}}; }
};

// The properties of a random scene of balls.
struct look {
    int count;
    int spread;     // of radii: the smallest is 2^-spread of the largest
    bool boxed;     // or free to fly off
    bool clustered; // in a corner of the box, with one ball far away
    int resting;    // one in this many rests; 0: none
    int fixed;      // one in this many is a mirror, at rest or not
    int late = 0;   // of every second ball the velocity is 2^-late of the others'
};

look any_look(int most) {
    return {property::in_range(1, most),
            property::in_range(0, 9),
            property::any<bool>(),
            property::any<bool>(),
            property::in_range(0, 3) * 2,
            property::in_range(0, 3) * 7,
            property::one_of(0, 0, 0, 8, 25, 60)};
}

template <int N>
parts_of_scene<N> any_scene(const look& l) {
    std::mt19937_64 random(property::any<std::uint64_t>());
    const auto fraction = [&] { return static_cast<double>(static_cast<std::int64_t>(random() >> 11)) * 0x1p-53; };
    const double side = l.clustered ? 2 : 10;
    parts_of_scene<N> s;
    for (int tries = 0; tries < 20 * l.count && static_cast<int>(s.balls.size()) < l.count; ++tries) {
        graze::ball<N> b{};
        b.radius = 0.4 * std::exp2(-l.spread * fraction());
        if (l.spread == 8 && fraction() < 0.2) {
            b.radius = 0;
        }
        for (int i = 0; i < N; ++i) {
            b.position[i] = 0.5 + (side - 1) * fraction();
            b.velocity[i] = l.resting > 0 && random() % static_cast<unsigned>(l.resting) == 0 ? 0 : 2 * fraction() - 1;
        }
        if (random() % 2 == 0) {
            b.velocity = std::exp2(-l.late) * b.velocity;
        }
        b.mass = 0.25 + fraction();
        if (l.fixed > 0 && random() % static_cast<unsigned>(l.fixed) == 0) {
            b.mass = std::numeric_limits<double>::infinity();
            b.velocity = graze::make_vec<N>([&](int) { return l.boxed || l.clustered ? 0.0 : 1e-3 * fraction(); });
        }
        if (std::none_of(s.balls.begin(), s.balls.end(), [&](const auto& other) {
                return std::sqrt(graze::squared_norm(other.position - b.position)) < other.radius + b.radius;
            })) {
            s.balls.push_back(b);
        }
    }
    if (l.clustered) {
        s.balls.push_back(
            {graze::make_vec<N>([](int) { return 9.0; }), graze::make_vec<N>([](int) { return 1e-2; }), 0.4, 1});
    }
    for (int i = 0; i < N && l.boxed; ++i) {
        graze::plane<N> p{};
        p.normal[i] = 2;
        s.planes.push_back(p);
        p.point[i] = 10;
        s.planes.push_back(p);
    }
    return s;
}

struct told_event {
    graze::scene_pair who;
    double time;
    bool operator==(const told_event&) const = default;
};

// What happened, and where it ended: how, the names of the two that may not meet if that was it, and all states.
template <int N>
struct story {
    std::vector<told_event> events;
    std::string end;
    std::vector<graze::flight<N>> flights;

    bool operator==(const story& other) const {
        return events == other.events && end == other.end &&
               std::equal(flights.begin(), flights.end(), other.flights.begin(), other.flights.end(),
                          [](const auto& f, const auto& g) {
                              return f.since == g.since && f.state.position == g.state.position &&
                                     f.state.velocity == g.state.velocity;
                          });
    }
};

template <class M>
story<M::dimension> told_by(graze::run<M>& run, std::uint64_t count) {
    story<M::dimension> s;
    while (s.end.empty()) {
        try {
            const auto done = run.advance({.events = count - s.events.size()}, [&](const graze::run_event<M>& e) {
                s.events.push_back({e.who, e.when});
            });
            s.end = to_string(done.why);
        } catch (const std::domain_error& e) {
            s.end = e.what();
        } catch (const graze::undecided&) { // and continues
        }
    }
    for (int i = 0; i < run.balls(); ++i) {
        s.flights.push_back(run.in_flight(i));
    }
    return s;
}

template <int N>
bool cells_have_no_part(int most, std::uint64_t events) {
    return property::check([=] {
        using plain = graze::plain_mechanics<N, double>;
        const look l = any_look(most);
        const auto s = any_scene<N>(l);
        graze::run<plain> with(s.scene());
        graze::run<plain> without(s.scene(), {}, graze::cells::none);
        const auto story_with = told_by(with, events);
        PROPERTY_ASSERT(story_with == told_by(without, events));
    });
}

// Plain mechanics that leave one in `one_in` questions undecided and, if vague, the order of equal times.
struct hesitant : graze::plain_mechanics<2, double> {
    using plain = graze::plain_mechanics<2, double>;
    std::shared_ptr<std::mt19937_64> random = std::make_shared<std::mt19937_64>();
    unsigned one_in = 0;
    bool vague = false;

    void hesitate() const {
        if (one_in != 0 && (*random)() % one_in == 0) {
            throw graze::undecided("whether to go on", 0);
        }
    }
    template <class S>
    std::optional<double> meet(const state& a, const S& b) const {
        hesitate();
        return plain::meet(a, b);
    }
    int order(double s, double t) const {
        hesitate();
        if (vague && s == t) {
            throw graze::undecided("the order of two times", s);
        }
        return plain::order(s, t);
    }
    template <class S>
    void bounce(state& a, S& b, double when) const {
        hesitate();
        plain::bounce(a, b, when);
    }
};

} // namespace

TEST_CASE("of two events that share no ball either is done first, where their order is undecided") {
    using ball = graze::ball<2, double>;
    std::vector<ball> balls{
        {{{0, 0}}, {{1, 0}}, 1}, {{{5, 0}}, {{0, 0}}, 1}, {{{0, 10}}, {{1, 0}}, 1}, {{{5, 10}}, {{0, 0}}, 1}};
    std::vector<graze::scene_pair> met;
    const auto note = [&](const auto& e) { met.push_back(e.who); };
    hesitant rules;
    rules.vague = true;
    graze::run<hesitant> apart(graze::scene<2, double>{balls, {}, {}}, rules);
    CHECK(apart.advance({}, note).why == graze::ending::exhausted);
    REQUIRE(met.size() == 2);
    std::sort(met.begin(), met.end());
    CHECK(met[0] == graze::scene_pair{graze::partner::ball, 0, 1});
    CHECK(met[1] == graze::scene_pair{graze::partner::ball, 2, 3});

    balls[2] = {{{10, 0}}, {{-1, 0}}, 1}; // balls on both sides meet ball 1
    balls[3].velocity[0] = 1;
    graze::run<hesitant> together(graze::scene<2, double>{balls, {}, {}}, rules);
    try {
        together.advance({}, note);
        FAIL("ball 1 was hit in some order");
    } catch (const graze::undecided& e) {
        REQUIRE(e.second());
        CHECK(((e.first()->a == 1) || (e.first()->b == 1)));
        CHECK(((e.second()->a == 1) || (e.second()->b == 1)));
        CHECK(e.first() != e.second());
    }
    CHECK(met.size() == 2);
}

TEST_CASE("with and without cells the sequence is the same, bit for bit") {
    CHECK(cells_have_no_part<2>(500, 400));
    CHECK(cells_have_no_part<3>(150, 300));
}

// Twenty fly apart, for ever, and long after they have done so a slow one goes to and fro between two mirrors: at first
// it is known that hardly any meet at all, and when that is no longer of use all balls have shells again.
TEST_CASE("what happens long after the last event is the same with and without cells") {
    std::vector<graze::ball<2>> balls;
    for (int i = 0; i < 20; ++i) {
        const double x = i % 5 - 2, y = i / 5 - 1.5;
        balls.push_back({{3 * x, 3 * y + 20}, {x * (1 + 0x1p-5 * i), y + 3}, 1});
    }
    constexpr double heavy = std::numeric_limits<double>::infinity();
    balls.push_back({{-4, 0}, {0, 0}, 1, heavy});
    balls.push_back({{4, 0}, {0, 0}, 1, heavy});
    balls.push_back({{0, 0}, {0x1p-40, 0}, 1});
    const graze::scene<2> s{.balls = balls};
    graze::run<graze::plain_mechanics<2, double>> with(s), without(s, {}, graze::cells::none);
    const auto expected = told_by(without, 300);
    CHECK(told_by(with, 300) == expected);
    CHECK(expected.events.back().time > 0x1p40);
}

TEST_CASE("exceptions in the middle of an event change nothing") {
    CHECK(property::check([] {
        const auto s = any_scene<2>(any_look(40));
        hesitant certain;
        hesitant unsure;
        graze::run<hesitant> straight(s.scene(), certain);
        graze::run<hesitant> interrupted(s.scene(), unsure);
        interrupted.rules().random->seed(property::any<std::uint64_t>());
        const auto expected = told_by(straight, 200);
        const_cast<hesitant&>(interrupted.rules()).one_in = 300; // only now: the first predictions have no run yet
        PROPERTY_ASSERT(told_by(interrupted, 200) == expected);
    }));
}

TEST_CASE("event by event is the same as at once") {
    CHECK(property::check([] {
        const auto s = any_scene<2>(any_look(60));
        using plain = graze::plain_mechanics<2, double>;
        graze::run<plain> whole(s.scene());
        graze::run<plain> steps(s.scene());
        const auto expected = told_by(whole, 150);
        story<2> told;
        while (told.events.size() < expected.events.size()) {
            const auto step = told_by(steps, property::in_range<std::uint64_t>(1, 5));
            told.events.insert(told.events.end(), step.events.begin(), step.events.end());
        }
        told.events.resize(expected.events.size());
        PROPERTY_ASSERT(told.events == expected.events);
    }));
}

TEST_CASE("velocities turned round bring a run back") {
    CHECK(property::check([] {
        auto s = any_scene<2>({20, 0, true, false, 0, 0});
        using plain = graze::plain_mechanics<2, double>;
        const plain rules;
        graze::run<plain> run(s.scene());
        const double turn = 1;
        const auto there = run.advance({.time = turn});
        run.restate([&](int, const auto& f) {
            auto b = rules.ball_at(f, turn);
            b.velocity = -b.velocity;
            return graze::flight<2>{b, turn};
        });
        const auto back = run.advance({.time = 2 * turn});
        PROPERTY_ASSERT(there.why == graze::ending::time);
        PROPERTY_ASSERT(back.events == there.events);
        for (int i = 0; i < run.balls(); ++i) {
            const auto b = rules.ball_at(run.in_flight(i), 2 * turn);
            const auto& start = s.balls[static_cast<std::size_t>(i)];
            for (int axis = 0; axis < 2; ++axis) { // a few events enlarge an error by no more than this factor
                PROPERTY_ASSERT(std::fabs(b.position[axis] - start.position[axis]) < 1e-6);
            }
        }
    }));
}

} // namespace grid_test
