// Times as values: their order, their ties, and what the standard library does with them.
#include "../predicate/answers.hpp"
#include "../predicate/transform.hpp"
#include "../soak/more_families.hpp"

#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <limits>
#include <queue>
#include <type_traits>
#include <vector>

namespace {

template <int N>
using ball = graze::ball<N, double>;
template <int N>
using plane = graze::plane<N, double>;
template <int N>
using wall = graze::wall<N, double>;
template <int N>
using impact = graze::impact_time<N, double>;

// A regular type without a default value: it can be copied, moved, assigned and compared, with itself and with a
// number.
template <class I, class T>
concept time_value = std::copyable<I> && std::equality_comparable<I> &&
    std::three_way_comparable<I, std::strong_ordering> && std::three_way_comparable_with<I, I> &&
    requires(const I& x, T t) {
    { x <=> t } -> std::same_as<std::partial_ordering>;
    { t <=> x } -> std::same_as<std::partial_ordering>;
    { x == t } -> std::same_as<bool>;
    { t != x } -> std::same_as<bool>;
    x < t&& t < x&& x >= t&& t >= x;
};
static_assert(time_value<impact<2>, double> && time_value<impact<3>, double>);
static_assert(time_value<graze::impact_time<3, float>, float>);
static_assert(time_value<graze::impact_time<2, std::int32_t>, std::int32_t>);
static_assert(time_value<graze::impact_time<2, std::int64_t>, std::int64_t>);
static_assert(!std::default_initializable<impact<3>>);
static_assert(std::is_trivially_copyable_v<impact<3>> && std::is_trivially_destructible_v<impact<3>>);
static_assert(std::is_nothrow_move_constructible_v<impact<3>> && std::is_nothrow_move_assignable_v<impact<3>>);

template <int N>
struct event {
    impact<N> time;
    oracle::surd truth;
};
template <class A, class B>
auto scene_pair(const A& a, const B& b) {
    return event<sizeof(a.position) / sizeof(double)>{answers::time_of(a, b).value(), oracle::meet(a, b).time.value()};
}

// Events of hard pairs from every family. One in four is a copy of another in a different form, so that ties are
// frequent.
template <int N>
std::vector<event<N>> hard_events(std::size_t of_each) {
    std::vector<event<N>> all;
    const auto add = [&](const auto& a, const auto& b) {
        if (!answers::time_of(a, b)) {
            return;
        }
        all.push_back(scene_pair(a, b));
        if (all.size() % 4 == 0) {
            all.push_back(scene_pair(transform::permuted(a, 1), transform::permuted(b, 1)));
            all.push_back(scene_pair(transform::reflected(a, 5), transform::reflected(b, 5)));
        }
    };
    const auto add_family = [&](const families::family& f) {
        for (std::size_t i = 0; i < of_each; ++i) {
            const auto pair = f.draw<N>(3, i);
            pair.kind == families::pair_kind::ball_ball    ? add(pair.a, pair.b)
            : pair.kind == families::pair_kind::ball_plane ? add(pair.a, pair.plane)
                                                           : add(pair.a, pair.wall);
        }
    };
    std::for_each(families::all_families.begin(), families::all_families.end(), add_family);
    std::for_each(families::more_families.begin(), families::more_families.end(), add_family);
    return all;
}

template <int N>
void check_order_of_all() {
    const auto all = hard_events<N>(4);
    REQUIRE(all.size() > 60);
    std::size_t ties = 0, wrong = 0, one_sided = 0;
    for (const auto& x : all) {
        for (const auto& y : all) {
            const int truth = oracle::compare(x.truth, y.truth);
            const auto order = x.time <=> y.time;
            wrong += order == (truth <=> 0) && (x.time == y.time) == (truth == 0) ? 0U : 1U;
            one_sided += (y.time <=> x.time) == (0 <=> order) ? 0U : 1U;
            ties += order == 0 && &x != &y ? 1U : 0U;
        }
    }
    CHECK(wrong == 0); // the order is that of real numbers, so it is transitive
    CHECK(one_sided == 0);
    CHECK(ties > all.size());
}

template <int N>
void check_containers() {
    const auto events = hard_events<N>(3);
    std::vector<impact<N>> times;
    for (const auto& e : events) {
        times.push_back(e.time);
    }
    auto truths = events;
    std::stable_sort(truths.begin(), truths.end(),
                     [](const auto& x, const auto& y) { return oracle::compare(x.truth, y.truth) < 0; });

    auto sorted = times;
    std::sort(sorted.begin(), sorted.end());
    std::priority_queue<impact<N>, std::vector<impact<N>>, std::greater<>> queue(times.begin(), times.end());
    for (std::size_t i = 0; i < times.size(); ++i) {
        CHECK(sorted[i] == truths[i].time);
        CHECK(queue.top() == truths[i].time);
        queue.pop();
    }
    CHECK(std::min(times.front(), times.back()) <= times.back());
    CHECK(*std::min_element(times.begin(), times.end()) == sorted.front());
    CHECK(*std::max_element(times.begin(), times.end()) == sorted.back());
    CHECK(std::is_sorted(sorted.begin(), sorted.end()));
}

// Two events that are a tie, whatever stage decides; and their order after y's radius changes by one unit in the last
// place.
template <int N, class A, class B, class C, class D>
void check_tie(const A& a, const B& b, const C& c, const D& d) {
    const auto x = scene_pair(a, b);
    const auto y = scene_pair(c, d);
    REQUIRE(oracle::compare(x.truth, y.truth) == 0);
    CHECK(x.time == y.time);
    CHECK((x.time <=> y.time) == 0);
    CHECK(!(x.time < y.time));
    CHECK(!(y.time < x.time));
    C larger = c;
    larger.radius = std::nextafter(c.radius, 9e9);
    const auto earlier = scene_pair(larger, d);
    REQUIRE(oracle::compare(earlier.truth, x.truth) < 0);
    CHECK(earlier.time < x.time);
    CHECK(x.time != earlier.time);
}

constexpr ball<2> flying{{-5, 1}, {3, -0.25}, 1};
constexpr ball<2> point_at_rest{{0, 0}, {0, 0}, 0};

} // namespace

TEST_CASE("A time is a small value") {
    CHECK(sizeof(impact<2>) == 128);
    CHECK(sizeof(impact<3>) == 168);
}

TEST_CASE("Any two times are ordered as the oracle orders them") {
    check_order_of_all<2>();
    check_order_of_all<3>();
}

TEST_CASE("Times in the standard library's hands") {
    check_containers<2>();
    check_containers<3>();
}

TEST_CASE("What is the same but for the axes, the place or the order is at the same time") {
    const ball<2> other{{0, 0}, {-0.1, 0.3}, 0.7};
    check_tie<2>(flying, other, other, flying);
    check_tie<2>(flying, other, transform::permuted(flying, 1), transform::permuted(other, 1));
    check_tie<2>(flying, other, transform::reflected(flying, 1), transform::reflected(other, 1));
    ball<2> far = flying, target{{0, 0}, {0, 0}, 1};
    check_tie<2>(flying, target, far, target);
    far.position = {{-5 + 0x1p40, 1 - 0x1p39}};
    const ball<2> far_target{{0x1p40, -0x1p39}, {0, 0}, 1};
    check_tie<2>(flying, target, far, far_target);
    far.velocity = {{3 + 0x1p30, -0.25}};
    check_tie<2>(flying, target, far, ball<2>{far_target.position, {{0x1p30, 0}}, 1});
    const ball<2> twice{{-10, 2}, {6, -0.5}, 2}; // with all lengths and velocities doubled
    check_tie<2>(flying, target, twice, ball<2>{{0, 0}, {0, 0}, 2});
}

TEST_CASE("Different kinds of things can be met at the same time") {
    // A point at rest; the end of a wall that lies behind it; the corner of a wall in space.
    const wall<2> behind{{0, 0}, {{{8, -1}}}};
    const wall<2> behind_from_its_end{{8, -1}, {{{-8, 1}}}};
    check_tie<2>(flying, point_at_rest, flying, behind);
    check_tie<2>(flying, behind, flying, point_at_rest);
    check_tie<2>(flying, behind, flying, behind_from_its_end);

    const ball<3> flying_in_space{{-5, 1, 0}, {3, -0.25, 0}, 1};
    const ball<3> point_in_space{{0, 0, 0}, {0, 0, 0}, 0};
    const wall<3> corner{{0, 0, 0}, {{{8, -1, 2}, {8, -1, -2}}}};
    const wall<3> edge{{0, 0, -4}, {{{8, -1, 0}, {0, 0, 8}}}};
    const wall<3> other_edge{{8, -1, 4}, {{{0, 0, -8}, {-8, 1, 0}}}};
    check_tie<3>(flying_in_space, point_in_space, flying_in_space, corner);
    check_tie<3>(flying_in_space, edge, flying_in_space, corner);
    check_tie<3>(flying_in_space, other_edge, flying_in_space, point_in_space);

    // A plane, and a wall whose face is in it, along no axis: the time is not rational.
    const plane<2> line{{1, 1}, {1, 2}};
    const wall<2> part{{9, -3}, {{{-20, 10}}}};
    const ball<2> falling{{-3, 7}, {0.5, -1}, 0.75};
    check_tie<2>(falling, line, falling, part);
    check_tie<2>(falling, part, falling, line);
    const plane<3> sheet{{1, 1, 1}, {2, 4, 6}};
    const wall<3> patch{{1 - 27, 1 + 9, 1 + 3}, {{{30, 0, -10}, {24, -18, 4}}}};
    const ball<3> falling_in_space{{1.5, 4, 5}, {-0.5, -1, -2}, 0.75};
    check_tie<3>(falling_in_space, sheet, falling_in_space, patch);

    // Everything that overlaps or touches now has the same time.
    const ball<2> inside{{0.5, 0}, {-1, 0}, 1};
    const ball<2> touching{{1, 0}, {-1, 0}, 1};
    CHECK(scene_pair(inside, point_at_rest).time == scene_pair(touching, point_at_rest).time);
    CHECK(scene_pair(inside, point_at_rest).time == scene_pair(touching, wall<2>{{0, 0}, {{{-1, 0}}}}).time);
    CHECK(scene_pair(inside, plane<2>{{0, 0}, {1, 0}}).time == scene_pair(touching, point_at_rest).time);
    CHECK(scene_pair(touching, plane<2>{{0, 0}, {1, 0}}).time == 0.0);
    CHECK(scene_pair(inside, point_at_rest).time == 0.0);
    CHECK(scene_pair(inside, point_at_rest).time == -0.0);
    CHECK(scene_pair(inside, point_at_rest).time > -0x1p-1074);
    CHECK(scene_pair(inside, point_at_rest).time < 0x1p-1074);
    CHECK(scene_pair(inside, point_at_rest).time < scene_pair(flying, point_at_rest).time);
}

TEST_CASE("A time against a number") {
    using limits = std::numeric_limits<double>;
    const ball<2> target{{0, 0}, {0, 0}, 1};
    const auto three = scene_pair(ball<2>{{5, 0}, {-1, 0}, 1}, target).time;
    CHECK(three == 3.0);
    CHECK(3.0 == three);
    CHECK(three < 3.0 + 0x1p-51);
    CHECK(three > 3.0 - 0x1p-51);
    CHECK(three >= 3.0);
    CHECK(three != 4.0);
    CHECK((three <=> limits::quiet_NaN()) == std::partial_ordering::unordered);
    CHECK((three <=> -limits::quiet_NaN()) == std::partial_ordering::unordered);
    CHECK(!(three == limits::quiet_NaN()));
    CHECK(three != limits::quiet_NaN());
    CHECK(!(three < limits::quiet_NaN()));
    CHECK(!(three >= limits::quiet_NaN()));
    CHECK(three < limits::infinity());
    CHECK(three > -limits::infinity());
    CHECK(three < limits::max());
    CHECK(three > limits::lowest());
    CHECK(three > limits::denorm_min());

    // Times beyond the range of doubles: about 2^2046, and below the least double.
    const ball<2> slow{{limits::max(), 0}, {-limits::denorm_min(), 0}, 0};
    const auto late = scene_pair(slow, point_at_rest).time;
    CHECK(late > limits::max());
    CHECK(late < limits::infinity());
    const ball<2> near{{0x1p-1073, 0}, {-limits::max(), 0}, 0x1p-1074};
    const auto soon = scene_pair(near, point_at_rest).time;
    CHECK(soon > 0.0);
    CHECK(soon < limits::denorm_min());
    CHECK(soon < late);

    // τ = 1 + 2^-53, between two doubles: dx = (1 + 2^-52, 0), R = 2^-53.
    const ball<2> midway{{1 + 0x1p-52, 0}, {-1, 0}, 0x1p-53};
    const auto middle = scene_pair(midway, point_at_rest).time;
    CHECK(middle > 1.0);
    CHECK(middle < 1 + 0x1p-52);

    const auto whole = graze::time_of_impact(graze::ball<2, std::int64_t>{{5, 0}, {-2, 0}, 0},
                                             graze::ball<2, std::int64_t>{{0, 0}, {0, 0}, 0});
    CHECK(*whole > 2);
    CHECK(*whole < 3);
    CHECK(*whole < std::numeric_limits<std::int64_t>::max());
    CHECK(*whole > std::numeric_limits<std::int64_t>::min());
    CHECK(*whole == 2.5); // 2.5 is not converted to an integer first
    CHECK(*whole == 2.5F);
    CHECK(*whole < 2.5000000000000004);

    // A third of a double that is no float.
    const auto narrow =
        graze::time_of_impact(graze::ball<2, float>{{5, 0}, {-3, 0}, 0}, graze::ball<2, float>{{0, 0}, {0, 0}, 0});
    CHECK(*narrow > 1.6666666);
    CHECK(*narrow > 5.0F / 3.0F);
    CHECK(*narrow < 5.0 / 3.0);
    CHECK(*narrow < 2);
    CHECK(*narrow > 1U);
    CHECK(*narrow > 1LL);

    // 2^53 + 1, which no double holds.
    const auto exact = graze::time_of_impact(graze::ball<2, std::int64_t>{{9007199254740993, 0}, {-1, 0}, 0},
                                             graze::ball<2, std::int64_t>{{0, 0}, {0, 0}, 0});
    CHECK(*exact == std::int64_t{9007199254740993});
    CHECK(*exact > std::int64_t{9007199254740992});
    CHECK(*exact > 9007199254740992.0);
    CHECK(*exact < 9007199254740994.0);
}

TEST_CASE("The stage that orders two times can be seen") {
    const ball<2> target{{0, 0}, {0, 0}, 1};
    const auto x = scene_pair(flying, target).time;
    const auto later = scene_pair(ball<2>{{-5, 1}, {2.9, -0.25}, 1}, target).time;
    const auto same = scene_pair(target, flying).time;
    const auto beside = scene_pair(ball<2>{{-5, 1}, {3, -0.25}, 1 + 0x1p-52}, target).time;
    auto told = graze::stage::exact;
    const auto tell = [&](graze::stage s) { told = s; };
    CHECK(x.compare(later, tell) == -1);
    CHECK(told == graze::stage::filter);
    CHECK(later.compare(x, tell) == 1);
    CHECK(told == graze::stage::filter);
    CHECK(x.compare(same, tell) == 0);
    CHECK(told == graze::stage::exact);
    CHECK(x.compare(beside, tell) == 1);
    CHECK(told == graze::stage::exact);
}
