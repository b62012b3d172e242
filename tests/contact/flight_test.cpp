// Contacts of flights: every component is judged at the boundaries of its rounding, by an oracle that moves the flights
// as rationals.
#include "../predicate/flight_answers.hpp"
#include "../predicate/flight_families.hpp"
#include "judge.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using graze::stage;
template <int N>
using flight = graze::flight<N>;

template <int N, class Truth, class T>
judge::verdict judged(const graze::flight<N, T>& a, const graze::flight<N, T>& b, const Truth& truth,
                      const std::optional<graze::contact<N, T>>& found) {
    judge::verdict v{truth.met.what, 0, {}, {}};
    if (found.has_value() != oracle::is_collision(truth.met.what)) {
        v.wrong = "the encounter";
    }
    if (!found || !v.wrong.empty()) {
        return v;
    }
    const auto c =
        oracle::contact(truth.a, truth.b, judge::inverse(a.state.mass), judge::inverse(b.state.mass), truth.met);
    judge::component(v, "time", *truth.time, found->time);
    judge::component(v, "position_a", c.position_a, found->position_a);
    judge::component(v, "position_b", c.position_b, found->position_b);
    judge::component(v, "normal", c.normal, found->normal);
    const bool graze = truth.met.what == oracle::encounter::graze;
    const auto velocity = [&](const char* name, const auto& before, const auto& exact, const auto& after) {
        if (graze || std::isinf(before.mass)) {
            judge::unchanged(v, name, before.velocity, after);
        } else {
            judge::component(v, name, exact, after);
        }
    };
    velocity("velocity_a", a.state, c.velocity_a, found->velocity_a);
    velocity("velocity_b", b.state, c.velocity_b, found->velocity_b);
    return v;
}

template <int N, class T, class Truth>
judge::verdict judged_face(const graze::flight<N, T>& f, const Truth& truth,
                           const std::optional<graze::wall_contact<N, T>>& found) {
    judge::verdict v{truth.met.what, 0, {}, {}};
    if (found.has_value() != oracle::is_collision(truth.met.what)) {
        v.wrong = "the encounter";
    }
    if (found && v.wrong.empty()) {
        const auto c = [&] {
            if constexpr (requires { truth.b.edge; }) {
                const unsigned which = truth.met.face ? 1U : truth.met.edges != 0 ? truth.met.edges : truth.met.corners;
                return oracle::contact(truth.a, truth.b, truth.met, truth.met.where(), std::countr_zero(which));
            } else {
                return oracle::contact(truth.a, truth.b, truth.met);
            }
        }();
        judge::component(v, "time", *truth.time, found->time);
        judge::component(v, "position", c.position, found->position);
        judge::component(v, "point", c.point, found->point);
        judge::component(v, "normal", c.normal, found->normal);
        if (v.what == oracle::encounter::graze) {
            judge::unchanged(v, "velocity", f.state.velocity, found->velocity);
        } else {
            judge::component(v, "velocity", c.velocity, found->velocity);
        }
    }
    return v;
}

struct tally {
    int contacts = 0, hits = 0, by_doubles = 0, ties = 0;
};

template <int N>
void look(tally& seen, unsigned which, std::uint64_t index) {
    const auto p = flight_families::draw<N>(which, 3, index);
    const auto found = flight_answers::of(p.a, p.b);
    const auto v = judged(p.a, p.b, oracle::meet(p.a, p.b), found.contact);
    CAPTURE(which);
    CAPTURE(index);
    CHECK(v.wrong == "");
    seen.contacts += found.contact ? 1 : 0;
    seen.hits += found.what == graze::encounter::hit ? 1 : 0;
    seen.by_doubles += found.contact && found.given_by == stage::filter ? 1 : 0;
    seen.ties += v.tied.empty() ? 0 : 1;
}

template <int N>
void look_at_walls(tally& seen, unsigned which, std::uint64_t index) {
    const auto f = flight_families::draw<N>(which, 4, index).a;
    families::random r(17, index);
    graze::vec<N, double> point{}, along{};
    for (int i = 0; i < N; ++i) {
        point[i] = flight_families::small(r, 4, 0);
        along[i] = 1 + std::fabs(flight_families::small(r, 9, 1));
    }
    graze::wall<N> wall{point, {}};
    wall.edge[0] = along;
    if constexpr (N == 3) {
        wall.edge[1] = {{-along[1], along[0], 3}};
    }
    const graze::plane<N> plane{point, along};
    const auto judge_one = [&](const auto& shape) {
        const auto found = flight_answers::of(f, shape);
        const auto v = judged_face(f, oracle::meet(f, shape), found.contact);
        CAPTURE(which);
        CAPTURE(index);
        CHECK(v.wrong == "");
        seen.contacts += found.contact ? 1 : 0;
        seen.by_doubles += found.contact && found.given_by == stage::filter ? 1 : 0;
    };
    judge_one(plane);
    judge_one(wall);
}

} // namespace

TEST_CASE("Contacts of flights are correctly rounded") {
    for (unsigned which = 0; which < 5; ++which) {
        tally seen;
        for (std::uint64_t index = 0; index < 150; ++index) {
            look<2>(seen, which, index);
            look<3>(seen, which, index);
        }
        CAPTURE(which);
        CHECK(seen.contacts > 10);
        if (which == 2) { // doubles with all their bits
            CHECK(seen.by_doubles >= seen.hits);
        }
        MESSAGE(which << ": " << seen.contacts << " contacts, " << seen.by_doubles << " by doubles alone, " << seen.ties
                      << " with a tie");
    }
}

TEST_CASE("Contacts of flights with planes and walls are correctly rounded") {
    tally seen;
    for (std::uint64_t index = 0; index < 150; ++index) {
        look_at_walls<2>(seen, static_cast<unsigned>(index % 5), index);
        look_at_walls<3>(seen, static_cast<unsigned>(index % 5), index);
    }
    CHECK(seen.contacts > 10);
    CHECK(seen.by_doubles > 10);
}

TEST_CASE("Flights of one since have the contact of their balls, but for the time") {
    int contacts = 0;
    for (std::uint64_t index = 0; index < 200; ++index) {
        auto p = flight_families::draw<3>(static_cast<unsigned>(index % 2), 21, index);
        p.a.since = p.b.since = 0;
        const auto at_zero = flight_answers::of(p.a, p.b).contact;
        p.a.since = p.b.since = 7.25;
        const auto later = flight_answers::of(p.a, p.b).contact;
        REQUIRE(at_zero.has_value() == later.has_value());
        if (at_zero) {
            ++contacts;
            CHECK(at_zero->position_a == later->position_a);
            CHECK(at_zero->position_b == later->position_b);
            CHECK(at_zero->normal == later->normal);
            CHECK(at_zero->velocity_a == later->velocity_a);
            CHECK(at_zero->velocity_b == later->velocity_b);
        }
    }
    CHECK(contacts > 10);
}

TEST_CASE("Bad flights are refused by name") {
    const double infinity = std::numeric_limits<double>::infinity();
    const flight<2> good{{{{9, 0}}, {{-1, 0}}, 1}, 0};
    const flight<2> rest{{{{0, 0}}, {{0, 0}}, 1}, 3};
    const auto thrown_by = [](const auto& a, const auto& b) -> std::string {
        try {
            (void)flight_answers::of(a, b);
        } catch (const std::domain_error& e) {
            return e.what();
        }
        return "nothing";
    };
    const auto with = [&](auto change) {
        auto f = good;
        change(f);
        return f;
    };
    CHECK(thrown_by(good, rest) == "nothing");
    const auto late = with([&](auto& f) { f.since = infinity; });
    const auto never = with([&](auto& f) { f.since = std::nan(""); });
    const auto lost = with([&](auto& f) { f.state.position[1] = infinity; });
    const auto wild = with([&](auto& f) { f.state.velocity[0] = -infinity; });
    const auto hollow = with([&](auto& f) { f.state.radius = -1; });
    const auto light = with([&](auto& f) { f.state.mass = 0; });
    const auto heavy = with([&](auto& f) { f.state.mass = infinity; });
    CHECK(thrown_by(late, rest) == "flight a: since is not finite");
    CHECK(thrown_by(rest, late) == "flight b: since is not finite");
    CHECK(thrown_by(late, late) == "flight a: since is not finite");
    CHECK(thrown_by(never, rest) == "flight a: since is not finite");
    CHECK(thrown_by(lost, rest) == "flight a: position is not finite");
    CHECK(thrown_by(rest, wild) == "flight b: velocity is not finite");
    CHECK(thrown_by(hollow, rest) == "flight a: radius is negative");
    CHECK(thrown_by(light, rest) == "flight a: mass is not positive");
    CHECK(thrown_by(heavy, heavy) == "flight b: mass is infinite, as that of flight a is");
    const graze::plane<2> plane{{{-5, 0}}, {{1, 0}}};
    CHECK(thrown_by(late, plane) == "flight: since is not finite");
    CHECK(thrown_by(hollow, plane) == "flight: radius is negative");
    CHECK(thrown_by(good, graze::plane<2>{{{-5, 0}}, {{0, 0}}}) == "plane: normal is zero");
}
