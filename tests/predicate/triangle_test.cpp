// Triangles: encounters, features, times and contacts against the oracle, and the laws, on every hard family of walls
// and on small whole numbers.
#include "../contact/judge.hpp"
#include "../oracle/flight.hpp"
#include "../property.hpp"
#include "../soak/more_families.hpp"
#include "answers_of_type.hpp"
#include "faults.hpp"
#include "laws.hpp"

#include <graze/collide.hpp>
#include <graze/predicate/classify_flights.hpp>
#include <graze/predicate/either_order.hpp>

#include <doctest/doctest.h>

#include <cstdint>

namespace {

using graze::encounter;
using graze::feature;
using ball = graze::ball<3, double>;
using wall = graze::wall<3, double>;
using triangle = graze::triangle<double>;

struct pair {
    ball a;
    triangle b;
};

// The half of the wall of the next pair with a wall in a family.
template <std::size_t Count>
pair any_of(const std::array<families::family, Count>& drawn) {
    const auto which = property::index_below(Count);
    const auto index = property::any<std::uint64_t>() % (1U << 20U);
    const bool turned = property::any<bool>();
    for (std::size_t k = which;; ++k) {
        const auto p = drawn[k % Count].template draw<3>(1, index + k / Count);
        if (p.kind != families::pair_kind::ball_wall) {
            continue;
        }
        triangle t{p.wall.corner, p.wall.edge};
        graze::vec<3, double> back = t.edge[0];
        if (turned && laws::add_exactly(back, -t.edge[1]) && laws::add_exactly(t.corner, t.edge[1])) {
            t.edge = {-p.wall.edge[1], back}; // edge 0 becomes the slanted one
        }
        return {p.a, t};
    }
}
pair small_pair() {
    const auto vector = [](int most) {
        return graze::make_vec<3>([&](int) { return static_cast<double>(property::in_range(-most, most + 1)); });
    };
    pair p{{vector(5), vector(2), static_cast<double>(property::in_range(0, 4))}, {vector(2), {vector(4), vector(4)}}};
    PROPERTY_PRE(faults::of(p.a, p.b).empty());
    return p;
}

// Encounter, feature, time and contact.
void check(const pair& p) {
    const auto& [b, t] = p;
    PROPERTY_ASSERT(answers::is_right(answers::of(b, t), b, t));
    const oracle::answer truth = oracle::meet(b, t);
    const graze::wall_encounter met = graze::classify_feature(b, t);
    PROPERTY_ASSERT(static_cast<int>(met.what) == static_cast<int>(truth.what));
    if (graze::is_collision(met.what)) {
        PROPERTY_ASSERT(static_cast<int>(met.where) == static_cast<int>(truth.where()));
        PROPERTY_ASSERT(truth.has(static_cast<oracle::feature>(met.where), met.index));
        property::tag(std::string(graze::to_string(met.where)) + std::to_string(met.index));
    }
    const auto contact = graze::collide(b, t);
    const judge::verdict v = judge::of(b, t, contact, answers::time_of(b, t));
    if (!v.wrong.empty()) {
        property::log(v.wrong);
    }
    PROPERTY_ASSERT(v.wrong.empty());
    PROPERTY_ASSERT(graze::classify_feature(t, b) == met);
    PROPERTY_ASSERT(graze::collide(t, b) == contact);
    PROPERTY_ASSERT(graze::overlaps(t, b) == truth.overlaps);

    const double since = property::one_of(0.0, 1.0, -0.375, 1e9);
    const graze::flight<3> f{b, since};
    PROPERTY_ASSERT(graze::classify_feature(f, t) == met);
    const auto later = graze::collide(f, t);
    PROPERTY_ASSERT(later.has_value() == contact.has_value());
    if (later) {
        const auto time = oracle::meet(f, t).time;
        PROPERTY_ASSERT(oracle::is_rounded(*time, later->time));
        PROPERTY_ASSERT(oracle::is_rounded(*time, static_cast<double>(*graze::time_of_impact(t, f))));
        auto same = *later;
        same.time = contact->time;
        PROPERTY_ASSERT(same == *contact);
    }
}

} // namespace

TEST_CASE("Triangles are met as the oracle says, and left as it says") {
    CHECK(property::check("of hard families", [] { check(any_of(families::all_families)); }));
    CHECK(property::check("of harder ones", [] { check(any_of(families::more_families)); }));
    CHECK(property::check("of small whole numbers", [] { check(small_pair()); }));
}

TEST_CASE("Triangles obey the laws") {
    const auto all = [](const pair& p) {
        laws::axes(p.a, p.b);
        laws::presentation(p.a, p.b);
        laws::scaling(p.a, p.b);
        laws::collisions_have_times(p.a, p.b);
        laws::overlap_is_now(p.a, p.b);
    };
    CHECK(property::check([&] { all(any_of(families::all_families)); }));
    CHECK(property::check([&] { all(small_pair()); }));
}

TEST_CASE("The first of a wall's two triangles is met when the wall is") {
    int tried = 0, exact = 0;
    const auto holds = [&](const pair& p) {
        ++tried;
        exact += laws::halves_make_a_wall(p.a, wall{p.b.corner, p.b.edge}) ? 1 : 0;
    };
    CHECK(property::check([&] { holds(any_of(families::all_families)); }));
    CHECK(property::check([&] { holds(small_pair()); }));
    CHECK(exact > tried / 3);
}

TEST_CASE("A ball that rolls over the seam of two triangles grazes it; one that is inside meets the edge") {
    const triangle first{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}}, second{{1, 1, 0}, {{{-1, 0, 0}, {0, -1, 0}}}};
    const ball rolls{{0.1, 0.1, 1}, {1, 1, 0}, 1};
    CHECK(graze::classify(rolls, first) == encounter::recede);
    CHECK(graze::classify_feature(rolls, second) == graze::wall_encounter{encounter::graze, feature::edge, 1});
    CHECK(graze::collide(rolls, second)->velocity == rolls.velocity);
    const double inside = 0x1p-20; // δ: the velocity across the edge changes by 2√(2δ/r) of itself, and by δ more
    const ball deep{{0.1, 0.1, 1 - inside}, {1, 1, 0}, 1};
    const auto met = graze::collide(deep, second);
    CHECK(met->feature == feature::edge);
    CHECK(met->index == 1);
    const double change = std::hypot(met->velocity[0] - 1, met->velocity[1] - 1, met->velocity[2]) / std::sqrt(2.0);
    CHECK(std::fabs(change / (2 * std::sqrt(2 * inside)) - 1) < inside);
}

// The ball that slides along them meets the border where it comes in, though only integers tell where it leaves.
TEST_CASE("A graze of a thin triangle names the feature that is met first") {
    const auto met = [](const ball& b, const triangle& t) {
        const auto [what, where, index] = graze::classify_feature(b, t);
        CHECK(what == encounter::graze);
        return std::pair(where, index);
    };
    const ball slow{
        {{-0x1.621953a2eb17p-7, 0x1.5436b87382fa6p-27, 0}}, {{0x1.02c431f01b37p+0, 0x1.40e1f0f09e048p-25, 0}}, 0};
    const triangle thin{{{0, 0, 0}},
                        {{{{0x1.fffffe615c3c7p-1, 0x1.cce265fc184a6p-25, 0}}, {{1, -0x1.586f795f284f5p-30, 0}}}}};
    CHECK(met(slow, thin) == std::pair(feature::edge, 2));
    const ball other{
        {{0x1.c828d8c7af05p-2, -0x1.c7ef70705366dp-51, 0}}, {{0x1.1beb939c287d8p-1, 0x1.221e983321c0cp-49, 0}}, 0};
    const triangle thinner{{{0, 0, 0}}, {{{{1, 0x1.72537a4f44421p-53, 0}}, {{1, 0x1.edcaad76e4fd4p-50, 0}}}}};
    CHECK(met(other, thinner) == std::pair(feature::edge, 2));
    const ball above{{{-1, 0, -1}}, {{-2, 0, 0}}, 1};
    const triangle needle{{{-2, 0, 0}}, {{{{0x1.4p-334, 0, 0}}, {{0x1.5d36818f05c02p-1, 0, 0x1.081b9bd52d3f8p-2}}}}};
    CHECK(met(above, needle) == std::pair(feature::corner, 1));
}

TEST_CASE("A bad triangle is named") {
    const ball b{{0, 0, 5}, {0, 0, -1}, 1};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const triangle& t :
         {triangle{{nan, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}}, triangle{{0, 0, 0}, {{{nan, 0, 0}, {0, 1, 0}}}},
          triangle{{0, 0, 0}, {{{0, 0, 0}, {0, 1, 0}}}}, triangle{{0, 0, 0}, {{{1, 2, 3}, {2, 4, 6}}}}}) {
        CHECK(faults::told(faults::of(b, t), [&] { (void)graze::classify(b, t); }));
        CHECK(faults::told(faults::of(b, t), [&] { (void)graze::overlaps(b, t); }));
        CHECK(faults::told(faults::of(b, t), [&] { (void)graze::time_of_impact(b, t); }));
        CHECK(faults::told(faults::of(b, t), [&] { (void)graze::collide(b, t); }));
    }
}
