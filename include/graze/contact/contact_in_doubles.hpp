// The contact of two movers rounded by doubles alone, where these leave no doubt.
#pragma once

#include <graze/contact/bound_impact.hpp>
#include <graze/contact/components.hpp>
#include <graze/contact/contact.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/machine/fused.hpp>

#include <bit>

namespace graze::inline v0_1::detail {

// Component `number` of a contact, as components.hpp counts them.
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline T& component(contact<N, T>& c, int number) noexcept {
    const int i = (number - 1) % 3;
    return number == 0   ? c.time
           : number < 4  ? c.position_a[i]
           : number < 7  ? c.position_b[i]
           : number < 10 ? c.normal[i]
           : number < 13 ? c.velocity_a[i]
                         : c.velocity_b[i];
}

// Whether the environment suits the steps in doubles. To nearest; and of doubles what a mode takes that reads or writes
// subnormals as zeros is less than 2^-1019 in y and s. Where these steps are good, 1/R is below 2^122 and φ below
// 2^103: less than 2^-790 in a velocity, and in t1 far less than its error. A subnormal float is up to 2^-126.
template <class T>
[[nodiscard, gnu::always_inline]] inline bool suits_contacts() noexcept {
    return std::is_same_v<T, float> ? rounds_to_nearest() : adds_to_nearest();
}

// Whether two numbers are equal, also where subnormals are read as zeros.
template <class T>
[[nodiscard]] constexpr bool is_same_number(const T& x, const T& y) noexcept {
    return bits_of(x) == bits_of(y) || (is_zero(x) && is_zero(y));
}

// Fills in components that need no arithmetic and that intervals leave open when they are 0: along an axis on which a
// ball does not move, or on which both balls have the same position and velocity. together: whether they started at one
// instant. Returns the components that are still open.
template <int N, class T>
[[nodiscard, gnu::noinline]] inline component_set fill_in_at_rest(component_set open_components, contact<N, T>& c,
                                                                  const ball<N, T>& a, const ball<N, T>& b,
                                                                  bool together) noexcept {
    const T zero(0);
    const auto set = [&](contact_component which, int i, T& to, const T& value) {
        const component_set bit = component_set{1} << (static_cast<int>(which) + i);
        if ((open_components & bit) != 0) {
            to = with_plain_zero(value);
        }
        open_components &= ~bit;
    };
    for (int i = 0; i < N; ++i) {
        if (is_zero(a.velocity[i])) {
            set(contact_component::position_a, i, c.position_a[i], a.position[i]);
        }
        if (is_zero(b.velocity[i])) {
            set(contact_component::position_b, i, c.position_b[i], b.position[i]);
        }
        if (is_same_number(a.position[i], b.position[i]) && is_same_number(a.velocity[i], b.velocity[i]) &&
            (together || is_zero(a.velocity[i]))) {
            set(contact_component::normal, i, c.normal[i], zero);
            set(contact_component::velocity_a, i, c.velocity_a[i], a.velocity[i]);
            set(contact_component::velocity_b, i, c.velocity_b[i], b.velocity[i]);
        }
    }
    return open_components;
}

// Takes bounded components: writes their upper ends, and notes which are certain; and the time as it is, for callers
// that scale it.
template <int N, class T>
struct rounded_components {
    contact<N, T>& c;
    component_set certain = 0;
    bounded<double> time{};

    [[gnu::always_inline]] void operator()(const bounded<double>& x, int number) noexcept {
        if (number == 0) {
            time = x;
        }
        const ends<double> interval = ends_of<T>(x);
        component(c, number) = static_cast<T>(interval.upper);
        certain |= component_set{agree<T>(interval)} << number;
    }
    [[gnu::always_inline]] void operator()(const bounded<lanes>& x, int first, int second) noexcept {
        const ends<lanes> interval = ends_of<T>(x);
        component(c, first) = static_cast<T>(interval.upper[0]);
        component(c, second) = static_cast<T>(interval.upper[1]);
        const unsigned two = agreeing<T>(interval);
        certain |= (two & 1U) << first | (two >> 1) << second;
    }
};

// Takes the components that doubles bound, for a hit near `time` from the start or for an overlap. The caller sets an
// overlap's time and, for balls, its positions. False if nothing is known.
template <class Taker, moving B>
struct hit_by_doubles {
    Taker& taken;
    const B &a, &b;
    double mass_a, mass_b, time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] bool operator()(std::bool_constant<Fused>) const noexcept {
        return bound_hit<Fused>(a, b, mass_a, mass_b, time, taken);
    }
};
template <class Taker, moving B>
struct overlap_by_doubles {
    Taker& taken;
    const B &a, &b;
    double mass_a, mass_b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] bool operator()(std::bool_constant<Fused>) const noexcept {
        return bound_overlap<Fused>(a, b, mass_a, mass_b, taken);
    }
};
// A hit is left to double words where products are not fused.
template <class Taker, moving B>
[[nodiscard, gnu::always_inline]] inline bool contact_by_doubles(Taker& taken, encounter what, const B& a, const B& b,
                                                                 double mass_a, double mass_b, double time) noexcept {
    if (what == encounter::overlap) {
        return with_fused_products(overlap_by_doubles<Taker, B>{taken, a, b, mass_a, mass_b}, false);
    }
    return with_fused_products(hit_by_doubles<Taker, B>{taken, a, b, mass_a, mass_b, time}, false);
}

// All components of a contact in N dimensions; and three of one vector.
template <int N>
inline constexpr component_set every_part = N == 3 ? 0xffffU : 0x6db7U;
[[nodiscard]] constexpr component_set three_from(contact_component first) noexcept {
    return component_set{7} << static_cast<int>(first);
}

// Writes the components that need no arithmetic and returns them: an overlap's time and the positions of balls that
// start then, a graze's velocities, and the velocity of a ball of infinite mass (the other's mass is then given as 0).
template <moving B, class Contact, class W>
constexpr component_set set_given(Contact& c, encounter what, const B& a, const B& b, const W& mass_a,
                                  const W& mass_b) noexcept {
    const auto& x = state_of(a);
    const auto& y = state_of(b);
    component_set given = 0;
    if (what == encounter::graze || is_zero(mass_b)) {
        c.velocity_a = x.velocity;
        given |= three_from(contact_component::velocity_a);
    }
    if (what == encounter::graze || is_zero(mass_a)) {
        c.velocity_b = y.velocity;
        given |= three_from(contact_component::velocity_b);
    }
    if (what == encounter::overlap) {
        const auto since = epochs_of(a, b);
        c.time = start_of(since);
        given |= 1;
        bool starts_a = true, starts_b = true;
        if constexpr (is_flight<B>) {
            starts_a = !is_earlier(since[0], since[1]);
            starts_b = !is_earlier(since[1], since[0]);
        }
        if (starts_a) {
            c.position_a = with_plain_zeros(x.position);
            given |= three_from(contact_component::position_a);
        }
        if (starts_b) {
            c.position_b = with_plain_zeros(y.position);
            given |= three_from(contact_component::position_b);
        }
    }
    return given;
}

// The components that are open once `certain` has been filled in.
template <moving B, class Contact>
[[nodiscard]] inline component_set open_after(component_set certain, Contact& c, encounter what, const B& a, const B& b,
                                              double mass_a, double mass_b) noexcept {
    constexpr int N = dimension_of<B>;
    if (what != encounter::hit || mass_a == 0 || mass_b == 0) {
        certain |= set_given(c, what, a, b, mass_a, mass_b);
    }
    const component_set open_components = every_part<N> & ~certain;
    if (open_components == 0) {
        return 0;
    }
    bool together = true;
    if constexpr (is_flight<B>) {
        together = bits_of(a.since) == bits_of(b.since);
    }
    return fill_in_at_rest(open_components, c, state_of(a), state_of(b), together);
}

// Fills in the components that are certain and returns the others; what: hit or overlap.
template <int N, class T, moving B>
[[nodiscard, gnu::noinline]] component_set contact_in_doubles(contact<N, T>& c, encounter what, const B& a, const B& b,
                                                              double mass_a, double mass_b, double time) noexcept {
    rounded_components<N, T> taken{c};
    const bool known = contact_by_doubles(taken, what, a, b, mass_a, mass_b, time);
    return open_after(known ? taken.certain : 0, c, what, a, b, mass_a, mass_b);
}

} // namespace graze::inline v0_1::detail
