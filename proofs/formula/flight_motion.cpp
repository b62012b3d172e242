// As identities: the motion of two flights, and the parabola with times that count from another instant. In rationals:
// which of two flights is moved on.
#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/flight_motion.hpp>
#include <graze/formula/root_order.hpp>

#include "../rational.hpp"
#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using proof::letters;
using proof::rational;
using proof::vector;

// Two balls whose coordinates are all letters, and their epochs.
template <int N>
constexpr ball<N, letters> ball_a{vector<N>(0), vector<N>(2 * N), letter(4 * N)};
template <int N>
constexpr ball<N, letters> ball_b{vector<N>(N), vector<N>(3 * N), letter(4 * N + 1)};
template <int N>
constexpr letters since_a = letter(4 * N + 2);
template <int N>
constexpr letters since_b = letter(4 * N + 3);

// The relative motion after the ball with the earlier epoch has moved on to the epoch of the other.
template <int N>
constexpr bool moves_on() {
    const auto now = relative_motion_of(ball_a<N>, ball_b<N>);
    const letters lead = since_b<N> - since_a<N>;
    const auto first_a = with_lead(now, ball_a<N>.velocity, lead);
    const auto first_b = with_lead(now, ball_b<N>.velocity, lead);
    return first_a.dx == position_at(ball_a<N>.position, ball_a<N>.velocity, lead) - ball_b<N>.position &&
           first_b.dx == ball_a<N>.position - position_at(ball_b<N>.position, ball_b<N>.velocity, -lead) &&
           first_a.du == now.du && first_b.du == now.du && first_a.R == now.R && first_b.R == now.R &&
           with_lead(now, ball_a<N>.velocity, letters(0)).dx == now.dx; // of one instant: balls
}
static_assert(moves_on<2>() && moves_on<3>());

// a t² + 2 h t + c is the same number at the same instant, on either clock.
constexpr quadratic<letters, letters, letters> general{letter(0), letter(1), letter(2)};
constexpr letters t = letter(3), start = letter(4);
constexpr letters at(const quadratic<letters, letters, letters>& q, const letters& x) {
    return q.a * x * x + twice(q.h * x) + q.c;
}
constexpr auto earlier = counted_from(general, start);
static_assert(at(earlier, t) == at(general, t - start));
static_assert(earlier.a == general.a);
static_assert(discriminant_halved{}(earlier) == discriminant_halved{}(general));
constexpr auto back = counted_from(earlier, -start);
static_assert(back.h == general.h && back.c == general.c);
static_assert(counted_from(general, letters(0)).c == general.c && counted_from(general, letters(0)).h == general.h);

// In rationals: the flight with the earlier epoch is moved on.
constexpr flight<2, rational> early{{{{1, 2}}, {{3, -1}}, 1}, rational(1, 2)};
constexpr flight<2, rational> late{{{{9, 0}}, {{-2, 5}}, 2}, rational(5, 2)};
constexpr auto forth = relative_motion_of(early, late);
constexpr auto reverse = relative_motion_of(late, early);
static_assert(forth.dx == vec<2, rational>{{rational(1 + 6 - 9), rational(2 - 2 - 0)}});
static_assert(reverse.dx == -forth.dx && reverse.du == -forth.du && reverse.R == forth.R);
static_assert(forth.du == vec<2, rational>{{5, -6}} && forth.R == rational(3));
// Even by a lead below 1. Flights with equal epochs are their balls.
constexpr flight<2, rational> barely{early.state, rational(9, 4)};
static_assert(relative_motion_of(barely, late).dx == vec<2, rational>{{rational(-29, 4), rational(7, 4)}});
constexpr flight<2, rational> together{late.state, early.since};
static_assert(relative_motion_of(early, together).dx == early.state.position - late.state.position);

// The order of two roots does not depend on the clock: for all small quadratics and shifts.
constexpr bool keeps_order() {
    const auto small = [](int i) { return quadratic<rational, rational, rational>{1 + i % 2, -1 - i / 2 % 3, i / 6}; };
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            const auto x = small(i);
            const auto y = small(j);
            if (sign(discriminant_halved{}(x)) < 0 || sign(discriminant_halved{}(y)) < 0) {
                continue;
            }
            for (const int shift : {-2, 1, 3}) {
                const rational s(shift);
                if (root_order{}(counted_from(x, s), counted_from(y, s)) != root_order{}(x, y)) {
                    return false;
                }
            }
        }
    }
    return true;
}
static_assert(keeps_order());

} // namespace
