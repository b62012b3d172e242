// All components of two balls' contact, from their motion in integers.
#pragma once

#include <graze/contact/contact.hpp>
#include <graze/contact/exact_approach.hpp>
#include <graze/contact/parts.hpp>
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

// An overlap's time and positions are no matter of its.
template <int N, class T, class M, class X, class U, class W, class From = from_now>
constexpr void round_balls(contact<N, T>& c, parts wanted, encounter what, const exact_balls<N, M, X, U, W>& e,
                           scales units, const From& counted = {}) {
    const auto twice_a = graze::twice(e.mass_a);
    const auto twice_b = graze::twice(e.mass_b);
    const auto sum = e.mass_a + e.mass_b;
    const auto velocities = [&](const auto& exact) {
        const auto divisor = exact.velocity_divisor(sum);
        if (graze::sign(e.mass_b) != 0) {
            fill(c.velocity_a, wanted, part::velocity_a, units.room,
                 [&](int i) { return exact.velocity(e.velocity_a[i], i, twice_b, divisor); });
        }
        if (graze::sign(e.mass_a) != 0) {
            fill(c.velocity_b, wanted, part::velocity_b, units.room,
                 [&](int i) { return exact.velocity(e.velocity_b[i], i, -twice_a, divisor); });
        }
    };
    if (what == encounter::overlap) {
        const exact_overlap<T, M> exact(e.relative, units);
        fill(c.normal, wanted, part::normal, units.room, [&](int i) { return exact.normal(i); });
        velocities(exact);
        return;
    }
    const exact_approach<T, M> exact(e.relative, units);
    if (has_time(wanted)) {
        c.time = exact.time(counted);
    }
    fill(c.position_a, wanted, part::position_a, units.room,
         [&](int i) { return exact.path.position(e.position_a[i], e.velocity_a[i]); });
    fill(c.position_b, wanted, part::position_b, units.room,
         [&](int i) { return exact.path.position(e.position_b[i], e.velocity_b[i]); });
    if (graze::sign(e.relative.R) != 0) { // otherwise two points, which graze
        fill(c.normal, wanted, part::normal, units.room, [&](int i) { return exact.normal(i); });
    }
    if (what == encounter::hit) {
        velocities(exact);
    }
}

} // namespace graze::inline v0_1::detail
