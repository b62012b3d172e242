// All components of two movers' contact, from their motion in integers.
#pragma once

#include <graze/contact/components.hpp>
#include <graze/contact/contact.hpp>
#include <graze/contact/exact_contact.hpp>
#include <graze/contact/masses.hpp>
#include <graze/formula/encounter.hpp>

namespace graze::inline v0_1::detail {

// Two balls in integers, with their masses; (1, 0) where the first one is infinite.
template <int N, class M, class X, class U, class W>
struct exact_balls {
    M relative;
    vec<N, X> position_a, position_b;
    vec<N, U> velocity_a, velocity_b;
    W mass_a, mass_b;
};

// For an overlap the caller sets time and positions.
template <int N, class T, class M, class X, class U, class W, class From = from_now>
constexpr void round_balls(contact<N, T>& c, component_set wanted, encounter what, const exact_balls<N, M, X, U, W>& e,
                           scales units, const From& counted = {}) {
    const auto twice_a = graze::twice(e.mass_a);
    const auto twice_b = graze::twice(e.mass_b);
    const auto sum = e.mass_a + e.mass_b;
    const auto velocities = [&](const auto& exact) {
        const auto divisor = exact.velocity_divisor(sum);
        if (graze::sign(e.mass_b) != 0) {
            fill(c.velocity_a, wanted, contact_component::velocity_a, units.room,
                 [&](int i) { return exact.velocity(e.velocity_a[i], i, twice_b, divisor); });
        }
        if (graze::sign(e.mass_a) != 0) {
            fill(c.velocity_b, wanted, contact_component::velocity_b, units.room,
                 [&](int i) { return exact.velocity(e.velocity_b[i], i, -twice_a, divisor); });
        }
    };
    if (what == encounter::overlap) {
        const exact_overlap<T, M> exact(e.relative, units);
        fill(c.normal, wanted, contact_component::normal, units.room, [&](int i) { return exact.normal(i); });
        velocities(exact);
        return;
    }
    const exact_contact<T, M> exact(e.relative, units);
    if (has_time(wanted)) {
        c.time = exact.time(counted);
    }
    fill(c.position_a, wanted, contact_component::position_a, units.room,
         [&](int i) { return exact.path.position(e.position_a[i], e.velocity_a[i]); });
    fill(c.position_b, wanted, contact_component::position_b, units.room,
         [&](int i) { return exact.path.position(e.position_b[i], e.velocity_b[i]); });
    if (graze::sign(e.relative.R) != 0) { // otherwise two points, which graze
        fill(c.normal, wanted, contact_component::normal, units.room, [&](int i) { return exact.normal(i); });
    }
    if (what == encounter::hit) {
        velocities(exact);
    }
}

// Rounds the wanted components of two movers in integers, `pair`, whose motion and positions are given at one instant,
// from which `from` counts.
template <class Contact, class Pair, class M, int N, class From>
constexpr void round_movers(Contact& c, component_set wanted, encounter what, const Pair& pair, const M& motion,
                            const vec<N, big_integer>& position_a, const vec<N, big_integer>& position_b,
                            const big_integer (&masses)[2], const scales& units, const From& from) {
    const exact_balls<N, M, big_integer, big_integer, big_integer> e{
        motion, position_a, position_b, pair.a.state.velocity, pair.b.state.velocity, masses[0], masses[1]};
    round_balls(c, wanted, what, e, units, from);
}

// Rounds the wanted positions of two centres, which are given.
template <int N, class T, class I>
constexpr void round_centres(contact<N, T>& c, component_set wanted, const vec<N, I>& position_a,
                             const vec<N, I>& position_b, const scales& units) {
    const auto rounded = [&](const I& x) { return round_to<T>(x, I(0), radicand<I>(), I(1), units.length); };
    fill(c.position_a, wanted, contact_component::position_a, units.room,
         [&](int i) { return rounded(position_a[i]); });
    fill(c.position_b, wanted, contact_component::position_b, units.room,
         [&](int i) { return rounded(position_b[i]); });
}

// Rounds the wanted components of the contact of two movers that meet, by integers. For an overlap the caller sets the
// time and the positions of those that start then.
template <moving B, class Contact>
[[gnu::noinline]] constexpr void complete(Contact& c, component_set wanted, encounter what, const B& a, const B& b) {
    constexpr int N = dimension_of<B>;
    using T = number_in<B>;
    using P = two_balls<N>;
    timed_workspace room;
    const auto& x = state_of(a);
    const auto& y = state_of(b);
    auto in = lift_timed<P>(packed<P>(x, y), epochs_of(a, b));
    in.settle(in.unit());
    in.use(room);
    lifted<2> mass;
    const T masses[2] = {effective_mass<T>(x.mass, y.mass), effective_mass<T>(y.mass, x.mass)};
    lift(mass, masses);
    mass.room = &room;
    const scales units{in.pair.length.exponent, in.pair.velocity.exponent, &room};
    const auto pair = flights_in(in);
    const auto round_all = [&](const auto& motion, const auto& position_a, const auto& position_b, const auto& from) {
        const big_integer masses_in[2] = {mass.template get<big_integer>(0), mass.template get<big_integer>(1)};
        round_movers(c, wanted, what, pair, motion, position_a, position_b, masses_in, units, from);
    };
    if constexpr (is_flight<B>) {
        const auto position_a = pair.position(pair.a);
        const auto position_b = pair.position(pair.b);
        if (what == encounter::overlap) {
            round_centres(c, wanted, position_a, position_b, units);
        }
        round_all(pair.motion(), position_a, position_b, from_earlier<big_integer>{pair.start()});
    } else {
        round_all(relative_motion_between(pair.a.state, pair.b.state), pair.a.state.position, pair.b.state.position,
                  from_now{});
    }
}

} // namespace graze::inline v0_1::detail
