// Decisions in constant expressions that proofs/predicate does not cover: the ends of the range, and bad input, which
// must not compile. All assertions are static.
#include <graze/predicate/classify_numbers.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <cstdint>
#include <limits>

namespace {

using namespace graze;
using enum encounter;

constexpr ball<2, double> resting{{0, 0}, {0, 0}, 1};
constexpr ball<2, double> coming(double height) { return {{5, height}, {-1, 0}, 1}; }

// Whole numbers up to the ends of their range.
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
static_assert(classify(ball<2, std::int64_t>{{most, most}, {-1, 0}, most}, ball<2, std::int64_t>{{-most, 0}, {}, 0}) ==
              encounter::graze);
static_assert(classify(ball<2, std::int64_t>{{most, most}, {-1, 0}, most}, ball<2, std::int64_t>{{-most, 0}, {}, 1}) ==
              hit);

constexpr plane<2, double> floor{{0, 0}, {0, 1}};
constexpr wall<2, double> segment{{0, 0}, {{{4, 0}}}};
static_assert(overlaps(ball<2, double>{{0, 0.5}, {1, 0}, 1}, floor));
static_assert(!overlaps(ball<2, double>{{5, 0}, {0, -1}, 1}, segment));

// Times: as values, in order, and against numbers.
constexpr auto first = time_of_impact(coming(0), resting);
constexpr auto second = time_of_impact(coming(1), resting);
static_assert(*first == 3.0 && *second > 3.0 && *second < 3.5);
static_assert((*first <=> *second) < 0);
static_assert(*first == *time_of_impact(ball<2, double>{{0, 4}, {0, -1}, 1}, floor));
static_assert(*first == *time_of_impact(ball<2, double>{{2, -4}, {0, 1}, 1}, segment));
static_assert(!time_of_impact(coming(9), resting));

// Exact types whose sums and products have other types.
using tracked = graze::integer<62>;
constexpr ball<3, tracked> falling(int x, int y) {
    return {{{tracked(x), tracked(y), tracked(10)}}, {{tracked(0), tracked(0), tracked(-1)}}, tracked(1)};
}
constexpr wall<3, tracked> table{{{tracked(-5), tracked(-5), tracked(0)}},
                                 {{{{tracked(10), tracked(0), tracked(0)}}, {{tracked(0), tracked(10), tracked(0)}}}}};
static_assert(classify(falling(0, 0), table) == encounter::hit);
static_assert(classify(falling(6, 0), table) == encounter::graze);
static_assert(classify(falling(6, 6), table) == encounter::miss);
static_assert(classify(falling(0, 0), falling(9, 0)) == encounter::recede);

// Any signed integer of 32 or 64 bits, whatever its name.
static_assert(classify(ball<2, long long>{{0, 4}, {0, -1}, 1}, ball<2, long long>{{0, 0}, {0, 0}, 1}) ==
              encounter::hit);
static_assert(classify(ball<2, long>{{0, 4}, {0, -1}, 1}, ball<2, long>{{2, 0}, {0, 0}, 1}) == encounter::graze);

// Whether F{}() is a constant expression.
template <class F>
concept constant = requires {
    typename std::integral_constant<bool, (F{}(), true)>;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
using good = decltype([] { return classify(resting, resting); });
using bad_position = decltype([] { return classify(ball<2, double>{{0, nan}, {0, 0}, 1}, resting); });
using bad_velocity = decltype([] { return overlaps(resting, ball<2, double>{{0, 0}, {infinity, 0}, 1}); });
using bad_radius = decltype([] { return time_of_impact(ball<2, double>{{0, 0}, {0, 0}, -1}, floor); });
using bad_normal = decltype([] { return classify(resting, plane<2, double>{{0, 0}, {0, 0}}); });
using bad_edge = decltype([] { return classify(resting, wall<2, double>{{0, 0}, {{{0, 0}}}}); });
using bad_edges = decltype([] {
    return classify(ball<3, double>{{}, {}, 1}, wall<3, double>{{}, {{{1, 2, 3}, {-2, -4, -6}}}});
});
static_assert(constant<good>);
static_assert(!constant<bad_position> && !constant<bad_velocity> && !constant<bad_radius> && !constant<bad_normal> &&
              !constant<bad_edge> && !constant<bad_edges>);

} // namespace
