// The contact of two balls rounded by doubles alone, as far as that leaves no doubt.
#pragma once

#include <graze/contact/bounded_impact.hpp>
#include <graze/contact/contact.hpp>
#include <graze/contact/parts.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/machine/fused.hpp>

namespace graze::inline v0_1::detail {

// Component `number` of a contact, as parts count them.
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline T& component(contact<N, T>& c, int number) noexcept {
    const int i = (number - 1) % 3;
    return number == 0   ? c.time
           : number < 4  ? c.position_a[i]
           : number < 7  ? c.position_b[i]
           : number < 10 ? c.normal[i]
           : number < 13 ? c.velocity_a[i]
                         : c.velocity_b[i];
}

// Components that no arithmetic is needed for, which the intervals leave open when they are 0: where a ball does not
// move along an axis, and where both are, and move, alike. together: whether they started at one instant. Returns those
// that are still open.
template <int N, class T>
[[nodiscard, gnu::noinline]] inline parts fill_in_at_rest(parts open_parts, contact<N, T>& c, const ball<N, T>& a,
                                                          const ball<N, T>& b, bool together) noexcept {
    const T zero(0);
    const auto set = [&](part which, int i, T& to, const T& value) {
        const parts bit = parts{1} << (static_cast<int>(which) + i);
        if ((open_parts & bit) != 0) {
            to = with_plain_zero(value);
        }
        open_parts &= ~bit;
    };
    for (int i = 0; i < N; ++i) {
        if (a.velocity[i] == zero) {
            set(part::position_a, i, c.position_a[i], a.position[i]);
        }
        if (b.velocity[i] == zero) {
            set(part::position_b, i, c.position_b[i], b.position[i]);
        }
        if (a.position[i] == b.position[i] && a.velocity[i] == b.velocity[i] && (together || a.velocity[i] == zero)) {
            set(part::normal, i, c.normal[i], zero);
            set(part::velocity_a, i, c.velocity_a[i], a.velocity[i]);
            set(part::velocity_b, i, c.velocity_b[i], b.velocity[i]);
        }
    }
    return open_parts;
}

// Takes what is bounded: writes the upper ends, and keeps which are certain.
template <int N, class T>
struct rounded_components {
    contact<N, T>& c;
    parts certain = 0;

    [[gnu::always_inline]] void operator()(const bounded<double>& x, int number) noexcept {
        const ends<double> interval = ends_of<T>(x);
        component(c, number) = static_cast<T>(interval.upper);
        certain |= parts{agree<T>(interval)} << number;
    }
    [[gnu::always_inline]] void operator()(const bounded<lanes>& x, int first, int second) noexcept {
        const ends<lanes> interval = ends_of<T>(x);
        component(c, first) = static_cast<T>(interval.upper[0]);
        component(c, second) = static_cast<T>(interval.upper[1]);
        const unsigned two = agreeing<T>(interval);
        certain |= (two & 1U) << first | (two >> 1) << second;
    }
};

// Fills in what doubles bound, of a hit near `time` or of an overlap, and says what is certain. Time and positions of
// an overlap are no matter of its.
template <int N, class T>
struct contact_by_doubles {
    contact<N, T>& c;
    const ball<N, T>&a, &b;
    double mass_a, mass_b, time;
    bool overlap;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] parts operator()(std::bool_constant<Fused>) const noexcept {
        rounded_components<N, T> taken{c};
        const bool known = overlap ? bound_overlap<Fused>(a, b, mass_a, mass_b, taken)
                                   : bound_hit<Fused>(a, b, mass_a, mass_b, time, taken);
        return known ? taken.certain : 0;
    }
};

// What is open when `certain` has been filled in. The velocity of a ball of infinite mass is its own.
template <int N, class T>
[[nodiscard]] inline parts open_after(parts certain, contact<N, T>& c, const ball<N, T>& a, const ball<N, T>& b,
                                      double mass_a, double mass_b, bool together = true) noexcept {
    constexpr parts every_part = N == 3 ? 0xffffU : 0x6db7U;
    constexpr parts of_velocity = 7;
    if (mass_a == 0) {
        c.velocity_b = b.velocity;
        certain |= of_velocity << static_cast<int>(part::velocity_b);
    }
    if (mass_b == 0) {
        c.velocity_a = a.velocity;
        certain |= of_velocity << static_cast<int>(part::velocity_a);
    }
    const parts open_parts = every_part & ~certain;
    return open_parts == 0 ? 0 : fill_in_at_rest(open_parts, c, a, b, together);
}

// Fills in the components that are certain and returns the others; what: hit or overlap.
template <int N, class T>
[[nodiscard, gnu::noinline]] inline parts fast_contact(contact<N, T>& c, encounter what, const ball<N, T>& a,
                                                       const ball<N, T>& b, double mass_a, double mass_b,
                                                       double time) noexcept {
    constexpr parts of_motion = 0x7fU; // time and positions
    const bool overlap = what == encounter::overlap;
    parts certain = with_best_products(contact_by_doubles<N, T>{c, a, b, mass_a, mass_b, time, overlap});
    if (overlap) {
        c.position_a = with_plain_zeros(a.position);
        c.position_b = with_plain_zeros(b.position);
        certain |= of_motion;
    }
    return open_after(certain, c, a, b, mass_a, mass_b);
}

} // namespace graze::inline v0_1::detail
