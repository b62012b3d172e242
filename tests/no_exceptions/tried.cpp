// What cannot throw, in a unit with or without exceptions: every pair kind, with answers and errors known by hand.
#include "questions.hpp"

#include <graze/batch.hpp>
#include <graze/checked.hpp>
#include <graze/exact/integer.hpp>

#include <array>
#include <cstring>
#include <limits>

#if defined(__cpp_exceptions)
#define TRIED tried_with_exceptions
#else
#define TRIED tried_without_exceptions
#endif

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
using graze::encounter;

template <class V>
constexpr bool is(const graze::result<V>& r, const V& expected) {
    return r.has_value() && *r == expected;
}
template <class V>
bool is_wrong(const graze::result<V>& r, const char* message, const char* field) {
    return !r.has_value() && r.error().message() == message && std::strcmp(r.error().field, field) == 0;
}

// In space, at rest, but for a ball that comes from the left and touches at a distance of 5.
constexpr graze::ball<3> coming{{-8, 0, 0}, {1, 0, 0}, 3};
constexpr graze::ball<3> resting{{0, 0, 0}, {0, 0, 0}, 2};
constexpr graze::ball<3> inside_out{{0, 0, 0}, {0, 0, 0}, -2};
constexpr graze::wall<3> upright{{0, -1, -1}, {{{0, 2, 0}, {0, 0, 2}}}};
constexpr graze::wall<3> folded{{0, -1, -1}, {{{0, 2, 0}, {0, -3, 0}}}};
constexpr graze::triangle<> sliver{{0, -1, -1}, {{{0, 2, 0}, {0, 0, 0}}}};

static_assert(is(graze::try_classify(coming, resting), encounter::hit));
static_assert(graze::try_collide(coming, resting)->value().time == 3);
static_assert(!graze::try_overlaps(upright, inside_out).has_value());
static_assert(!graze::try_classify_feature(folded, coming).has_value());
static_assert(noexcept(graze::try_time_of_impact(coming, upright)) && noexcept(graze::try_collide(coming, upright)));

bool balls() {
    auto mirror = coming, other = resting;
    mirror.mass = other.mass = infinite;
    return is(graze::try_classify(coming, resting), encounter::hit) &&
           is(graze::try_overlaps(coming, resting), false) && **graze::try_time_of_impact(coming, resting) == 3 &&
           (*graze::try_collide(coming, resting))->velocity_a == graze::vec<3, double>{{0, 0, 0}} &&
           is_wrong(graze::try_classify(coming, inside_out), "ball b: radius is negative", "radius") &&
           is_wrong(graze::try_overlaps(inside_out, coming), "ball a: radius is negative", "radius") &&
           is_wrong(graze::try_time_of_impact(coming, inside_out), "ball b: radius is negative", "radius") &&
           (*graze::try_collide(mirror, resting))->velocity_b == graze::vec<3, double>{{2, 0, 0}} &&
           is_wrong(graze::try_collide(mirror, other), "ball b: mass is infinite, as that of ball a is", "mass") &&
           graze::try_classify(mirror, other).has_value();
}

bool flights() {
    const graze::flight<3> first{coming, 1};
    graze::flight<3> second{resting, -infinite};
    const graze::plane<3> wide{{0, 0, 0}, {1, 0, 0}}, flat{{0, 0, 0}, {0, 0, 0}};
    bool right = is_wrong(graze::try_classify(first, second), "flight b: since is not finite", "since") &&
                 is_wrong(graze::try_collide(flat, first), "plane: normal is zero", "normal") &&
                 is_wrong(graze::try_classify(second, wide), "flight: since is not finite", "since");
    second.since = 0;
    right = right && **graze::try_time_of_impact(first, second) == 4 && (*graze::try_collide(wide, first))->time == 6;
    second.state.mass = -1;
    return right && is_wrong(graze::try_collide(first, second), "flight b: mass is not positive", "mass");
}

bool walls() {
    return is(graze::try_classify(upright, coming), encounter::hit) &&
           is(graze::try_overlaps(resting, upright), true) &&
           graze::try_classify_feature(coming, upright)->where == graze::feature::face &&
           **graze::try_time_of_impact(upright, coming) == 5 && (*graze::try_collide(coming, upright))->time == 5 &&
           is_wrong(graze::try_classify(coming, folded), "wall: edges are parallel", "edge") &&
           is_wrong(graze::try_overlaps(coming, folded), "wall: edges are parallel", "edge") &&
           is_wrong(graze::try_time_of_impact(folded, coming), "wall: edges are parallel", "edge") &&
           is_wrong(graze::try_collide(coming, folded), "wall: edges are parallel", "edge") &&
           is_wrong(graze::try_classify_feature(sliver, coming), "triangle: edge is zero", "edge") &&
           is_wrong(graze::try_collide(upright, inside_out), "ball: radius is negative", "radius");
}

// A user's own shape, and exact numbers.
struct particle {
    graze::vec<3, double> position, velocity;
    double radius;
};
bool others() {
    const particle own{{-8, 0, 0}, {1, 0, 0}, 3}, bad{{infinite, 0, 0}, {1, 0, 0}, 3};
    using whole = graze::integer<8>;
    const graze::ball<2, whole> a{{whole(-8), whole(0)}, {whole(1), whole(0)}, whole(3)};
    const graze::ball<2, whole> b{{whole(0), whole(0)}, {whole(0), whole(0)}, whole(-2)};
    return is(graze::try_classify(own, resting), encounter::hit) &&
           is_wrong(graze::try_classify(resting, bad), "ball b: position is not finite", "position") &&
           is(graze::try_classify(a, a), encounter::recede) &&
           is_wrong(graze::try_classify(a, b), "ball b: radius is negative", "radius") &&
           is_wrong(graze::try_classify(graze::wall<2, whole>{{whole(0), whole(0)}, {{{whole(0), whole(0)}}}}, a),
                    "wall: edge is zero", "edge");
}

bool batches() {
    std::array<graze::ball<3>, 5> many;
    many.fill(coming);
    std::array<encounter, 5> what{};
    graze::batch::classify(many, resting, what);
    return what[0] == encounter::hit && what[4] == encounter::hit;
}

} // namespace

bool TRIED() { return balls() && flights() && walls() && others() && batches(); }
