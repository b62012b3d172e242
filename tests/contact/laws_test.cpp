// Properties of every contact, on pairs of every family: laws of symmetry, values that do not change, bad input.
#include "../predicate/transform.hpp"
#include "answers.hpp"

#include "../soak/soak.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace contact_laws_test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// f(a, b) of pairs of every family.
template <int N, class F>
void each_pair(F f) {
    for (const families::family& family : soak::families_drawn) {
        CAPTURE(family.name);
        for (std::uint64_t index = 0; index < 24; ++index) {
            CAPTURE(index);
            const auto pair = family.draw<N>(5, index);
            if (pair.kind == families::pair_kind::ball_ball) {
                f(pair.a, pair.b);
            } else if (pair.kind == families::pair_kind::ball_plane) {
                f(pair.a, pair.plane);
            } else {
                f(pair.a, pair.wall);
            }
        }
    }
}

// A contact whose vectors are replaced by length(v), velocity(v) or normal(v), depending on what they are.
template <int N, class L, class V, class E>
graze::contact<N> apply(graze::contact<N> c, L length, V velocity, E normal) {
    c.position_a = length(c.position_a);
    c.position_b = length(c.position_b);
    c.normal = normal(c.normal);
    c.velocity_a = velocity(c.velocity_a);
    c.velocity_b = velocity(c.velocity_b);
    return c;
}
template <int N, class L, class V, class E>
graze::wall_contact<N> apply(graze::wall_contact<N> c, L length, V velocity, E normal) {
    c.position = length(c.position);
    c.point = length(c.point);
    c.normal = normal(c.normal);
    c.velocity = velocity(c.velocity);
    return c;
}

// Whether all numbers, times 2^power[kind] for lengths, velocities and normals, are normal or 0 before and after.
template <int N>
auto scaling(int power, bool& exact) {
    return [power, &exact](const graze::vec<N, double>& x) {
        return graze::make_vec<N>([&](int i) {
            const double y = std::ldexp(x[i], power);
            exact = exact && (x[i] == 0 || (std::isnormal(x[i]) && std::isnormal(y)));
            return y;
        });
    };
}

template <int N>
void permute_and_mirror() {
    each_pair<N>([](const auto& a, const auto& b) {
        const auto found = answers::of(a, b).contact;
        const auto turn = [](const graze::vec<N, double>& x) {
            return graze::make_vec<N>([&](int i) { return x[(i + 1) % N]; });
        };
        const auto mirror = [](const graze::vec<N, double>& x) {
            return graze::make_vec<N>([&](int i) { return i != 1 ? -x[i] : x[i]; });
        };
        const auto turned = answers::of(transform::permuted(a, 1), transform::permuted(b, 1)).contact;
        const auto mirrored = answers::of(transform::reflected(a, 5), transform::reflected(b, 5)).contact;
        REQUIRE(turned.has_value() == found.has_value());
        REQUIRE(mirrored.has_value() == found.has_value());
        if (found) {
            CHECK(*turned == apply(*found, turn, turn, turn));
            CHECK(*mirrored == apply(*found, mirror, mirror, mirror));
        }
    });
}

template <int N>
void scale() {
    int compared = 0;
    each_pair<N>([&](const auto& a, const auto& b) {
        for (const int power : {-37, 300}) {
            bool exact = true;
            const auto grown = [&](const auto& shape) {
                const auto length = scaling<N>(power, exact);
                const auto velocity = scaling<N>(5, exact);
                const auto same = [](const auto& x) { return x; };
                auto r = transform::apply(shape, length, velocity, same);
                if constexpr (requires { r.radius; }) {
                    r.radius = length(graze::vec<N, double>{{r.radius}})[0];
                    r.mass = std::ldexp(r.mass, -11);
                }
                return r;
            };
            const auto x = grown(a);
            const auto y = grown(b);
            const auto found = answers::of(a, b).contact;
            if (!exact || !found) {
                continue;
            }
            auto expected =
                apply(*found, scaling<N>(power, exact), scaling<N>(5, exact), [](const auto& v) { return v; });
            expected.time = scaling<N>(power - 5, exact)(graze::vec<N, double>{{found->time}})[0];
            if (exact) {
                const auto result = answers::of(x, y).contact;
                REQUIRE(result.has_value());
                CHECK(*result == expected);
                ++compared;
            }
        }
    });
    CHECK(compared > 300);
}

template <int N>
void swap_balls() {
    each_pair<N>([](const auto& a, const auto& b) {
        if constexpr (std::is_same_v<std::decay_t<decltype(b)>, graze::ball<N>>) {
            const auto found = answers::of(a, b).contact;
            const auto swapped = answers::of(b, a).contact;
            REQUIRE(swapped.has_value() == found.has_value());
            if (found) {
                CHECK(found->time == swapped->time);
                CHECK(found->position_a == swapped->position_b);
                CHECK(found->position_b == swapped->position_a);
                CHECK(found->normal == -swapped->normal);
                CHECK(found->velocity_a == swapped->velocity_b);
                CHECK(found->velocity_b == swapped->velocity_a);
            }
        }
    });
}

template <class X, class Y>
std::string thrown_by(const X& x, const Y& y) {
    try {
        (void)answers::of(x, y);
    } catch (const std::domain_error& e) {
        return e.what();
    }
    return {};
}

using ball = graze::ball<2>;

} // namespace

TEST_CASE("axes may be exchanged and mirrored") {
    permute_and_mirror<2>();
    permute_and_mirror<3>();
}

TEST_CASE("lengths, velocities and masses may be scaled by powers of two") {
    scale<2>();
    scale<3>();
}

TEST_CASE("two balls may be exchanged") {
    swap_balls<2>();
    swap_balls<3>();
}

TEST_CASE("equal masses head-on exchange their velocities") {
    const auto c = answers::of(ball{{0, 0}, {0.1, 0}, 0.3}, ball{{7, 0}, {-0.7, 0}, 0.2}).contact;
    REQUIRE(c.has_value());
    CHECK(c->velocity_a == graze::vec<2, double>{-0.7, 0});
    CHECK(c->velocity_b == graze::vec<2, double>{0.1, 0});
}

TEST_CASE("what does not change keeps its bits") {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    // A graze, and a ball of infinite mass.
    const auto grazed = answers::of(ball{{0, 0}, {1, -0.0}, 1}, ball{{9, 2}, {-0.1, 0.0}, 1}).contact;
    REQUIRE(grazed.has_value());
    CHECK(bits(grazed->velocity_a[1]) == bits(-0.0));
    CHECK(grazed->velocity_b[0] == -0.1);
    const ball wall_like{{0, 0}, {-0.0, -0.0}, 1, infinity};
    for (const ball& other : {ball{{9, 0}, {-1, 0}, 1}, ball{{9, 0.1}, {-0.3, 0}, 1}, ball{{1, 0}, {-1, 0.5}, 1}}) {
        const auto c = answers::of(wall_like, other).contact;
        REQUIRE(c.has_value());
        CHECK(bits(c->velocity_a[0]) == bits(-0.0));
        CHECK(bits(c->velocity_a[1]) == bits(-0.0));
        const auto d = answers::of(other, wall_like).contact;
        CHECK(bits(d->velocity_b[0]) == bits(-0.0));
        CHECK(bits(d->velocity_b[1]) == bits(-0.0));
    }
}

TEST_CASE("now is +0, and so is every exact zero") {
    const auto touching = answers::of(ball{{-2, -0.0}, {1, -0.0}, 1}, ball{{0, -0.0}, {-0.0, -0.0}, 1}).contact;
    const auto inside = answers::of(ball{{-1, -0.0}, {1, -0.0}, 1}, ball{{0, -0.0}, {-0.0, -0.0}, 1}).contact;
    for (const auto& c : {touching, inside}) {
        REQUIRE(c.has_value());
        CHECK(!std::signbit(c->time));
        CHECK(c->time == 0);
        CHECK(!std::signbit(c->position_a[1]));
        CHECK(!std::signbit(c->position_b[0]));
        CHECK(c->normal == graze::vec<2, double>{-1, 0});
        CHECK(!std::signbit(c->normal[1]));
        CHECK(!std::signbit(c->velocity_a[1]));
    }
    const auto on_plane = answers::of(ball{{-1, -0.0}, {1, -0.0}, 1}, graze::plane<2>{{0, 0}, {-3, -0.0}}).contact;
    REQUIRE(on_plane.has_value());
    CHECK(on_plane->normal == graze::vec<2, double>{-1, 0});
    CHECK(!std::signbit(on_plane->point[0]));
    CHECK(!std::signbit(on_plane->velocity[1]));
}

TEST_CASE("two points have no normal, and a plane's has no length") {
    const auto points = answers::of(ball{{-2, 0}, {1, 0}, 0}, ball{{0, 0}, {0, 0}, 0}).contact;
    REQUIRE(points.has_value());
    CHECK(points->normal == graze::vec<2, double>{0, 0});
    CHECK(points->velocity_a == graze::vec<2, double>{1, 0});
    const ball b{{0.1, 5}, {0.3, -1}, 0.7};
    const auto unit = answers::of(b, graze::plane<2>{{0, 0}, {0.3, 0.7}}).contact;
    const auto long_one = answers::of(b, graze::plane<2>{{0, 0}, {std::ldexp(0.3, 900), std::ldexp(0.7, 900)}}).contact;
    const auto other_side = answers::of(b, graze::plane<2>{{0, 0}, {-0.3, -0.7}}).contact;
    REQUIRE(unit.has_value());
    CHECK(unit == long_one);
    CHECK(unit == other_side);
}

TEST_CASE("beyond the largest number is an infinity") {
    const double most = std::numeric_limits<double>::max();
    const auto late = answers::of(ball{{most, 0}, {-0x1p-1074, 1}, 1}, ball{{0, 0}, {0, 1}, 1});
    REQUIRE(late.contact.has_value());
    CHECK(late.contact->time == infinity);
    CHECK(late.contact->position_a[1] == infinity);
    CHECK(late.time->lower() == most);
    CHECK(late.time->upper() == infinity);
}

TEST_CASE("bad masses are named") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ball good{{0, 0}, {1, 0}, 1};
    const auto with_mass = [](double mass) { return ball{{9, 0}, {0, 0}, 1, mass}; };
    for (const double mass : {0.0, -0.0, -1.0, nan, -infinity, -0x1p-1074}) {
        CHECK(thrown_by(good, with_mass(mass)) == "ball b: mass is not positive");
        CHECK(thrown_by(with_mass(mass), good) == "ball a: mass is not positive");
    }
    CHECK(thrown_by(with_mass(infinity), with_mass(infinity)) == "ball b: mass is infinite, as that of ball a is");
    CHECK(thrown_by(with_mass(0x1p-1074), good).empty());
    // Against a plane the mass is not used.
    CHECK(thrown_by(with_mass(nan), graze::plane<2>{{0, 0}, {1, 0}}).empty());
    CHECK(thrown_by(ball{{0, 0}, {1, 0}, -1}, good) == "ball a: radius is negative");
}

} // namespace contact_laws_test
