// Flights, compared with the oracle, which moves them as rationals: decisions, times, their order, the laws.
#include "../property.hpp"
#include "flight_answers.hpp"
#include "flight_families.hpp"
#include "transform.hpp"

#include "../oracle/rounding.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <source_location>
#include <vector>

namespace {

using graze::stage;
template <int N>
using flight = graze::flight<N>;

template <int N, class T, class B>
bool is_right(const graze::flight<N, T>& a, const B& b) {
    const auto found = flight_answers::of(a, b);
    const auto truth = oracle::meet(a, b);
    if (static_cast<int>(found.what) != static_cast<int>(truth.met.what) || found.overlaps != truth.met.overlaps ||
        found.time.has_value() != truth.time.has_value()) {
        return false;
    }
    if (!truth.time) {
        return true;
    }
    const auto rounded = flight_answers::rounded(*found.time);
    bool right = oracle::is_rounded(*truth.time, rounded.nearest) &&
                 oracle::is_rounded(*truth.time, rounded.lower, oracle::direction::downward) &&
                 oracle::is_rounded(*truth.time, rounded.upper, oracle::direction::upward);
    for (const T m :
         {rounded.nearest, rounded.lower, rounded.upper, T(0), static_cast<T>(rounded.nearest / 2), a.since}) {
        right = right && (!std::isfinite(m) || flight_answers::order_of(*found.time, m) ==
                                                   oracle::compare(*truth.time, mpq_class(oracle::input(m))));
    }
    return right;
}

template <int N>
flight_families::pair<N> any() {
    const auto which = property::in_range<unsigned>(0, 5);
    const auto index = property::any<std::uint64_t>();
    return flight_families::draw<N>(which, 5, index % (1U << 20U));
}
template <int N>
graze::plane<N> any_plane() {
    const auto index = property::any<std::uint64_t>();
    families::random r(9, index);
    graze::plane<N> p{};
    for (int i = 0; i < N; ++i) {
        p.point[i] = flight_families::small(r, 4, 0);
        p.normal[i] = flight_families::small(r, 2, 0);
    }
    p.normal[0] += p.normal[0] >= 0 ? 1 : 0;
    p.normal[0] -= p.normal[0] < 0 ? 1 : 0;
    return p;
}
template <int N>
graze::wall<N> any_wall() {
    const auto ground = any_plane<N>();
    graze::wall<N> w{ground.point, {}};
    w.edge[0] = ground.normal;
    if constexpr (N == 3) {
        w.edge[1] = {{-ground.normal[1], ground.normal[0], 1}}; // not parallel to it
    }
    return w;
}

template <int N>
struct event {
    graze::impact_time<N> time;
    oracle::surd truth;
};
template <int N, class B>
void add(std::vector<event<N>>& all, const flight<N>& a, const B& b) {
    if (const auto found = flight_answers::of(a, b); found.time) {
        all.push_back({*found.time, *oracle::meet(a, b).time});
    }
}
template <int N>
bool are_in_order(const std::vector<event<N>>& all, int& ties, int& exact) {
    bool right = true;
    for (const auto& x : all) {
        for (const auto& y : all) {
            auto decided_by = stage::filter;
            const int order = flight_answers::order_of(x.time, y.time, decided_by);
            right = right && order == oracle::compare(x.truth, y.truth);
            ties += order == 0 ? 1 : 0;
            exact += decided_by == stage::exact ? 1 : 0;
        }
    }
    return right;
}

template <int N, class F>
flight<N> changed(flight<N> f, F change) {
    f.state = change(f.state);
    return f;
}
template <int N>
bool same(const flight_answers::answer<N, double, graze::contact<N>>& x,
          const flight_answers::answer<N, double, graze::contact<N>>& y) {
    auto told = stage::filter;
    return x.what == y.what && x.overlaps == y.overlaps && x.time.has_value() == y.time.has_value() &&
           (!x.time || flight_answers::order_of(*x.time, *y.time, told) == 0);
}

// Laws 1 and 2, and law 3 also with a common scale of time.
template <int N>
void check_laws(const flight<N>& a, const flight<N>& b) {
    const auto answer = flight_answers::of(a, b);
    PROPERTY_ASSERT(same<N>(flight_answers::of(b, a), answer));
    const auto permuted = [](const auto& x) { return transform::permuted(x, 1); };
    PROPERTY_ASSERT(same<N>(flight_answers::of(changed(a, permuted), changed(b, permuted)), answer));
    const auto reflected = [](const auto& x) { return transform::reflected(x, 5); };
    PROPERTY_ASSERT(same<N>(flight_answers::of(changed(a, reflected), changed(b, reflected)), answer));
    PROPERTY_ASSERT(answer.time.has_value() == graze::is_collision(answer.what));
}

template <int N>
bool scaled_alike(const flight<N>& a, const flight<N>& b, int length, int time) {
    const auto scale = [&](flight<N> f) {
        f.state = transform::scaled(
            f.state, [&](double x, int kind) { return std::ldexp(x, kind == 0 ? length : length - time); });
        f.since = std::ldexp(f.since, time);
        return f;
    };
    const auto x = flight_answers::of(a, b);
    const auto y = flight_answers::of(scale(a), scale(b));
    if (x.what != y.what || x.overlaps != y.overlaps) {
        return false;
    }
    return !x.time ||
           std::ldexp(flight_answers::rounded(*x.time).nearest, time) == flight_answers::rounded(*y.time).nearest;
}

} // namespace

TEST_CASE("Flights do what the oracle says") {
    std::map<graze::encounter, int> seen;
    std::map<stage, int> decided;
    const auto look = [&](const auto& p) {
        PROPERTY_ASSERT(is_right(p.a, p.b));
        const auto found = flight_answers::of(p.a, p.b);
        ++seen[found.what];
        ++decided[found.decided_by];
    };
    const auto look_at_three = [&](auto draw) {
        for (int i = 0; i < 3; ++i) {
            look(draw());
        }
    };
    CHECK(property::check([&] { look_at_three([] { return any<2>(); }); }));
    CHECK(property::check([&] { look_at_three([] { return any<3>(); }); }));
    for (const auto what : {graze::encounter::overlap, graze::encounter::recede, graze::encounter::miss,
                            graze::encounter::graze, graze::encounter::hit}) {
        CAPTURE(to_string(what));
        CHECK(seen[what] > 2);
    }
    CHECK(decided[stage::filter] > 20);
    CHECK(decided[stage::exact] > 20);
}

TEST_CASE("A flight does to planes and walls what the oracle says") {
    CHECK(property::check([] {
        const auto f = any<2>().a;
        PROPERTY_ASSERT(is_right(f, any_plane<2>()));
        PROPERTY_ASSERT(is_right(f, any_wall<2>()));
    }));
    CHECK(property::check([] {
        const auto f = any<3>().b;
        PROPERTY_ASSERT(is_right(f, any_plane<3>()));
        PROPERTY_ASSERT(is_right(f, any_wall<3>()));
    }));
}

TEST_CASE("Floats fly as doubles do") {
    CHECK(property::check([] {
        const auto p = any<2>();
        const auto narrow = [](const flight<2>& f) {
            const auto number = [](double x) { return static_cast<float>(x); };
            const auto vector = [&](const graze::vec<2, double>& v) {
                return graze::make_vec<2>([&](int i) { return number(v[i]); });
            };
            return graze::flight<2, float>{
                {vector(f.state.position), vector(f.state.velocity), number(f.state.radius), number(f.state.mass)},
                number(f.since)};
        };
        const auto a = narrow(p.a), b = narrow(p.b);
        const auto is_finite = [](const graze::flight<2, float>& f) {
            return std::isfinite(f.state.position[0]) && std::isfinite(f.state.position[1]) &&
                   std::isfinite(f.state.velocity[0]) && std::isfinite(f.state.velocity[1]) &&
                   std::isfinite(f.state.radius) && f.state.mass > 0 && std::isfinite(f.since);
        };
        PROPERTY_PRE(is_finite(a) && is_finite(b) && !(std::isinf(a.state.mass) && std::isinf(b.state.mass)));
        PROPERTY_ASSERT(is_right(a, b));
    }));
}

TEST_CASE("Times of different epochs and kinds are in their exact order") {
    int ties = 0, exact = 0;
    const bool right = property::check([&] {
        std::vector<event<2>> flat;
        std::vector<event<3>> solid;
        for (int i = 0; i < 6; ++i) {
            const auto p = any<2>();
            add(flat, p.a, p.b);
            add(flat, p.a, any_plane<2>());
            add(flat, p.b, any_wall<2>());
            const auto q = any<3>();
            add(solid, q.a, q.b);
            add(solid, q.a, any_wall<3>());
        }
        PROPERTY_ASSERT(are_in_order(flat, ties, exact));
        PROPERTY_ASSERT(are_in_order(solid, ties, exact));
    });
    CHECK(right);
    CHECK(exact > 0);
    CHECK(ties > 0);
}

TEST_CASE("The answer does not depend on axes, on the order of arguments or on units") {
    CHECK(property::check([] {
        const auto p = any<2>();
        check_laws(p.a, p.b);
        const auto q = any<3>();
        check_laws(q.a, q.b);
    }));
    CHECK(property::check([] { // of numbers that leave room
        const auto index = property::any<std::uint64_t>();
        const auto p = flight_families::draw<3>(static_cast<unsigned>(index % 3), 6, index);
        PROPERTY_ASSERT(scaled_alike(p.a, p.b, property::in_range(-300, 300), property::in_range(-100, 100)));
    }));
}

TEST_CASE("Law 13: the answer does not depend on when the clock was set") {
    int shifted = 0;
    CHECK(property::check([&] {
        const auto index = property::any<std::uint64_t>();
        const auto p = flight_families::draw<3>(static_cast<unsigned>(index % 2), 8, index);
        const double shift = std::ldexp(static_cast<double>(property::in_range(-1000, 1000)), -4);
        auto a = p.a, b = p.b;
        a.since += shift;
        b.since += shift;
        const auto before = flight_answers::of(p.a, p.b);
        const auto after = flight_answers::of(a, b);
        PROPERTY_ASSERT(before.what == after.what);
        if (before.time) {
            ++shifted;
            const auto expected = *oracle::meet(p.a, p.b).time + oracle::rational(mpq_class(shift));
            PROPERTY_ASSERT(oracle::is_rounded(expected, flight_answers::rounded(*after.time).nearest));
        }
    }));
    CHECK(shifted > 10);
}

TEST_CASE("A flight equals itself seen from a later start") {
    // The same motion given at another epoch, moved exactly, so that every time is a tie.
    int ties = 0, moved_on = 0;
    CHECK(property::check([&] {
        const auto index = property::any<std::uint64_t>();
        const auto p = flight_families::draw<2>(0, 12, index);
        auto later = p.a;
        later.since += 4;
        for (int i = 0; i < 2; ++i) {
            later.state.position[i] += 4 * later.state.velocity[i];
        }
        const auto x = flight_answers::of(p.a, p.b);
        const auto y = flight_answers::of(later, p.b);
        if (x.time && y.time && later.since <= flight_answers::rounded(*x.time).lower) {
            ++moved_on;
            auto told = stage::filter;
            PROPERTY_ASSERT(flight_answers::order_of(*x.time, *y.time, told) == 0);
            ties += told == stage::exact ? 1 : 0;
        }
    }));
    CHECK(moved_on > 3);
    CHECK(ties > 0);
}

TEST_CASE("Easy flights are decided by the filter, hard ones by integers") {
    using graze::encounter;
    const auto at = [](double x, double y, double u, double v, double since, double radius = 1) {
        return flight<2>{{{{x, y}}, {{u, v}}, radius}, since};
    };
    const auto expect = [](encounter what, stage decided_by, const flight<2>& a, const flight<2>& b,
                           std::source_location here = std::source_location::current()) {
        CAPTURE(here.line());
        const auto found = flight_answers::of(a, b);
        CHECK(found.what == what);
        CHECK(found.decided_by == decided_by);
        CHECK(is_right(a, b));
    };
    expect(encounter::hit, stage::filter, at(9, 0.5, -1, 0, 0), at(0, 0, 0, 0, 3));
    expect(encounter::miss, stage::filter, at(9, 2.5, -1, 0, 0), at(0, 0, 0, 0, 3));
    expect(encounter::overlap, stage::filter, at(9, 0.5, -1, 0, 0), at(0, 0, 0, 0, 8));
    expect(encounter::recede, stage::filter, at(9, 0.5, -1, 0, 0), at(0, 0, 0, 0, 10)); // it has passed through
    expect(encounter::hit, stage::filter, at(0, 0, 0, 0, 3), at(9, 0.5, -1, 0, 0));
    expect(encounter::hit, stage::filter, at(9, 0.5, -1, 0, 1e6), at(-1e6, 0, 1, 0, 0)); // it comes from far behind
    expect(encounter::hit, stage::exact, at(9, 0, -1, 0, 0), at(0, 0, 0, 0, 7)); // they touch when the other one starts
    expect(encounter::overlap, stage::double_word, at(9, 0, -1, 0, 0), at(0, 0, 0, 0, 7 + 0x1p-50));
    expect(encounter::graze, stage::exact, at(9, 2, -1, 0, 0), at(0, 0, 0, 0, 3));
    expect(encounter::graze, stage::exact, at(9, 0, -1, 0, 0, 0), at(0, 0, 0, 0, 3, 0)); // points that meet
    expect(encounter::hit, stage::refined, at(9, 0, -1, 0, -0x1p-1074), at(0, 0, 0, 0, 0));
    expect(encounter::hit, stage::filter, at(9, 0, -0x1p-600, 0, 0), at(0, 0, 0, 0, 0x1p600));
    expect(encounter::overlap, stage::exact, at(9, 0, -0x1p-1074, 0, 0), at(0, 0, 0, 0, 0x1.fffp1023, 9));
    expect(encounter::recede, stage::filter, at(9, 0, 0, 0, 0), at(0, 0, 0, 0, 3));
}
