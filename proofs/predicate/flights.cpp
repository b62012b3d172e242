// Flights as constants: every encounter after the later epoch, ties of different epochs, points among mirrors.
#include <graze/graze.hpp>

namespace {

using namespace graze;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ulp = 0x1p-52;

// A flight along the axis at height y, which is at x = 0 at t = 1, and a ball at rest at (10, 0) from `since` on.
constexpr flight<2> mover(double y) { return {{{{0, y}}, {{1, 0}}, 1}, 1}; }
constexpr flight<2> target(double since) { return {{{{10, 0}}, {{0, 0}}, 1}, since}; }
constexpr encounter pass(double y, double since) { return classify(mover(y), target(since)); }
static_assert(pass(0, 3) == encounter::hit);
static_assert(pass(0, 9) == encounter::hit); // touching
static_assert(pass(0, 9 + 16 * ulp) == encounter::overlap);
static_assert(pass(0, 11) == encounter::recede); // the centres are one
static_assert(pass(2, 3) == encounter::graze);
static_assert(pass(2 - ulp, 3) == encounter::hit);
static_assert(pass(2 + 2 * ulp, 3) == encounter::miss);
static_assert(overlaps(mover(0), target(10)) && !overlaps(mover(0), target(9)));

// Whatever the target's epoch, the time is exactly the same; if the target is already touched then, it is the epoch.
static_assert(*time_of_impact(mover(0), target(3)) == 9.0);
static_assert(*time_of_impact(mover(1), target(3)) == *time_of_impact(target(8), mover(1)));
static_assert(*time_of_impact(mover(1), target(3)) < *time_of_impact(mover(1.5), target(-7)));
static_assert(*time_of_impact(mover(0), target(9.5)) == 9.5);
static_assert(static_cast<double>(*time_of_impact(mover(1), target(3))) == 0x1.28930a2f4f66bp3); // 11 - √3
static_assert(time_of_impact(mover(1), target(3))->lower() < *time_of_impact(mover(1), target(3)));
static_assert(!time_of_impact(mover(3), target(3)));

// Against a plane and a wall, on the same clock.
constexpr plane<2> end{{{9, 0}}, {{2, 0}}};
constexpr wall<2> segment{{{9, -1}}, {{{{0, 2}}}}};
static_assert(*time_of_impact(mover(0), end) == *time_of_impact(mover(0), target(2)));
static_assert(*time_of_impact(mover(0), segment) == *time_of_impact(mover(0), end));
static_assert(collide(mover(0), end)->time == 9 && collide(mover(0), end)->position[0] == 8);

// A point among mirrors: its velocity is reversed, the mirror's stays, the time is absolute.
constexpr flight<2> photon{{{{0.5, 0.25}}, {{1, 0}}, 0}, 2};
constexpr flight<2> mirror{{{{2.5, 0.25}}, {{0, 0}}, 0.5, infinity}, 0};
constexpr auto bounce = *collide(photon, mirror);
static_assert(bounce.time == 3.5 && bounce.position_a == vec<2, double>{{2, 0.25}});
static_assert(bounce.velocity_a == vec<2, double>{{-1, 0}} && bounce.velocity_b == vec<2, double>{{0, 0}});
static_assert(bounce.normal == vec<2, double>{{-1, 0}});

// The laws of classify_balls.hpp, on an exact tangent, a hit, a miss and an overlap of different epochs.
constexpr bool same(const flight<2>& a, const flight<2>& b, const flight<2>& c, const flight<2>& d) {
    const auto x = time_of_impact(a, b);
    const auto y = time_of_impact(c, d);
    return classify(a, b) == classify(c, d) && overlaps(a, b) == overlaps(c, d) && x.has_value() == y.has_value() &&
           (!x || *x == *y);
}
template <class F>
constexpr flight<2> each(flight<2> f, F change) {
    change(f);
    return f;
}
static_assert(pass(0.5, 9.5) == encounter::overlap);
template <class Law>
constexpr bool of_passes = Law{}(mover(2), target(3)) && Law{}(mover(2 - ulp), target(3)) &&
                           Law{}(mover(2 + 2 * ulp), target(3)) && Law{}(mover(0.5), target(9.5));
// 1. Axes permuted and mirrored. 2. Exchanged.
struct axes_and_order {
    constexpr bool operator()(const flight<2>& a, const flight<2>& b) const {
        const auto turn = [](flight<2>& f) {
            f.state.position = {{f.state.position[1], -f.state.position[0]}};
            f.state.velocity = {{f.state.velocity[1], -f.state.velocity[0]}};
        };
        const auto mirrored = [](flight<2>& f) {
            f.state.position[0] = -f.state.position[0];
            f.state.velocity[0] = -f.state.velocity[0];
        };
        return same(a, b, each(a, turn), each(b, turn)) && same(a, b, each(a, mirrored), each(b, mirrored)) &&
               same(a, b, b, a);
    }
};
static_assert(of_passes<axes_and_order>);
// 3. Lengths and times scaled, and with the times every since.
struct scaling {
    constexpr bool operator()(const flight<2>& a, const flight<2>& b) const {
        const auto longer = [](flight<2>& f) {
            f = {{8.0 * f.state.position, 4.0 * f.state.velocity, 8 * f.state.radius}, 2 * f.since};
        };
        const auto x = time_of_impact(a, b);
        const auto y = time_of_impact(each(a, longer), each(b, longer));
        return classify(a, b) == classify(each(a, longer), each(b, longer)) && x.has_value() == y.has_value() &&
               (!x || ((*x <=> 9.5) == (*y <=> 19.0) && (*x <=> 11.0) == (*y <=> 22.0)));
    }
};
static_assert(of_passes<scaling>);
// 4. Another frame, in which the flight with the later epoch has moved by then; and another place.
struct frame {
    constexpr bool operator()(const flight<2>& a, const flight<2>& b) const {
        const auto moving = [](flight<2>& f) {
            f.state.position[0] = f.state.position[0] + 64 - 4 * f.since;
            f.state.velocity[0] = f.state.velocity[0] - 4;
        };
        return same(a, b, each(a, moving), each(b, moving));
    }
};
static_assert(of_passes<frame>);
// 6. Collisions have a time, other encounters have none. The time of an overlap is the later epoch.
struct times_of_collisions {
    constexpr bool operator()(const flight<2>& a, const flight<2>& b) const {
        const auto time = time_of_impact(a, b);
        return time.has_value() == is_collision(classify(a, b)) &&
               (classify(a, b) != encounter::overlap || *time == (a.since > b.since ? a.since : b.since));
    }
};
static_assert(of_passes<times_of_collisions>);

// 12. Flights of equal epochs do what their balls do. 13. One number may be added to all epochs.
constexpr ball<3> a{{{0, 0, 0}}, {{1, 0.5, 0}}, 1}, b{{{6, 2, 1}}, {{-1, 0, 0.25}}, 1.5};
static_assert(classify(flight<3>{a, 4}, flight<3>{b, 4}) == classify(a, b));
static_assert(static_cast<double>(*time_of_impact(flight<3>{a, 0}, flight<3>{b, 0})) ==
              static_cast<double>(*time_of_impact(a, b)));
static_assert(*time_of_impact(flight<3>{a, 4}, flight<3>{b, 5}) < *time_of_impact(flight<3>{a, 5}, flight<3>{b, 6}));
static_assert(collide(flight<3>{a, 4}, flight<3>{b, 5})->velocity_a ==
              collide(flight<3>{a, 5}, flight<3>{b, 6})->velocity_a);

} // namespace
