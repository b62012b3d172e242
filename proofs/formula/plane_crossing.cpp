// Eqs. (31) to (33), completed: at the time of touch the centre is at distance r from the plane. Where the formula asks
// for a sign, letters count as positive, so each side of the plane has a proof of its own.
#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using proof::vector;
using function = rational_function<512>;

// The plane's point and normal, the ball's position and velocity as letters.
template <int N>
constexpr bool seen_from_the_plane() {
    using letters = proof::letters;
    const ball<N, letters> b{vector<N>(0), vector<N>(N), letter(4 * N)};
    const plane<N, letters> p{vector<N>(2 * N), vector<N>(3 * N)};
    const auto m = relative_motion_of(b, p);
    for (int k = 0; k < N; ++k) {
        if (m.w[k] != letter(k) - letter(2 * N + k)) {
            return false;
        }
    }
    return m.u == b.velocity && m.n == p.normal && m.r == b.radius;
}
static_assert(seen_from_the_plane<2>() && seen_from_the_plane<3>());

// w, u, n, r; L = |n|. Side is the sign of w·n.
template <int N>
constexpr plane_motion<N, function, function, function, function> seen(int side) {
    const vec<N, function> w = vector<N, function>(0);
    return {side > 0 ? w : -w, vector<N, function>(N), vector<N, function>(2 * N), letter<function>(3 * N)};
}
template <int N>
constexpr function length_of_normal() {
    return letter<function>(3 * N + 1);
}

// (32) at any time: (w + u t)·n = height + speed t.
template <int N>
constexpr bool height_in_time() {
    const auto m = seen<N>(1);
    const function t = letter<function>(15);
    return dot(position_at(m.w, m.u, t), m.n) == plane_height{}(m) + plane_speed{}(m)*t;
}
static_assert(height_in_time<2>() && height_in_time<3>());

// The centre is on the plane at (33) as printed, at r|n| on its own side at (33) completed.
template <int N>
constexpr bool touches(int side) {
    const auto m = seen<N>(side);
    const function height = plane_height{}(m);
    const function speed = plane_speed{}(m);
    const function reach = m.r * length_of_normal<N>();
    const function touch = plane_touch_time{}(height, speed, reach);
    const function centre = centre_crossing_time{}(height, speed);
    return dot(position_at(m.w, m.u, centre), m.n) == function(0) &&
           dot(position_at(m.w, m.u, touch), m.n) == function(side) * reach;
}
static_assert(touches<2>(1) && touches<2>(-1) && touches<3>(1) && touches<3>(-1));

// As a quadratic: (height + speed t)² - r² n·n with D = speed² r² n·n. The time of touch is a root of it, the smaller
// one if the ball approaches, since it is √D/a before the centre's time.
template <int N>
constexpr bool squared(int side) {
    const auto m = seen<N>(side);
    const auto q = quadratic_of(m);
    const function height = plane_height{}(m);
    const function speed = plane_speed{}(m);
    const function reach = m.r * length_of_normal<N>();
    const function t = letter<function>(15);
    const function above = height + speed * t;
    const function touch = plane_touch_time{}(height, speed, reach);
    const function remainder = m.r * m.r * (length_of_normal<N>() * length_of_normal<N>() - squared_norm(m.n));
    return q.a * t * t + twice(q.h) * t + q.c == above * above - m.r * m.r * squared_norm(m.n) &&
           q.a * touch * touch + twice(q.h) * touch + q.c == remainder && plane_clearance{}(m) == q.c &&
           discriminant_halved{}(q) == speed * speed * m.r * m.r * squared_norm(m.n);
}
static_assert(squared<2>(1) && squared<2>(-1) && squared<3>(1) && squared<3>(-1));

} // namespace
