// The contact of two movers that plain doubles leave open: scaled if their units are unusual, then in double words.
#pragma once

#include <graze/contact/word_contact.hpp>
#include <graze/time/scaled_rounding.hpp>

#include <bit>

namespace graze::inline v0_1::detail {

// x times 2^power, without a branch; of its components that are normal numbers it returns those that stay such.
template <int N>
[[nodiscard, gnu::always_inline]] inline component_set scale_back(vec<N, double>& x, contact_component first,
                                                                  int power) noexcept {
    const auto shift = static_cast<std::uint64_t>(std::int64_t{power}) << 52;
    component_set normal = 0;
    for (int i = 0; i < N; ++i) {
        const std::uint64_t bits = bits_of(x[i]);
        const auto exponent = static_cast<int>(bits >> 52 & 0x7ff) + power;
        normal |= component_set{static_cast<unsigned>(exponent - 1) < 0x7feU} << (static_cast<int>(first) + i);
        x[i] = std::bit_cast<double>(bits + shift);
    }
    return normal;
}

// The same for a contact, from units of lengths and velocities of 2^length and 2^velocity: returns those of its certain
// components that stay normal numbers, and the time. All were such, since their bounds include `underflow`. Nothing is
// known of the others.
template <int N>
[[nodiscard]] component_set scale_back(const rounded_components<N, double>& x, int length, int velocity) noexcept {
    contact<N, double>& c = x.c;
    component_set done = x.certain & (1U | scale_back(c.position_a, contact_component::position_a, length) |
                                      scale_back(c.position_b, contact_component::position_b, length) |
                                      three_from(contact_component::normal) |
                                      scale_back(c.velocity_a, contact_component::velocity_a, velocity) |
                                      scale_back(c.velocity_b, contact_component::velocity_b, velocity));
    if (has_time(done)) {
        const auto time = rounded_quickly<double>(x.time, length - velocity);
        c.time = *time;
        done -= time ? 0 : 1;
    }
    return done;
}

// Copies these components.
template <int N, class T>
[[gnu::always_inline]] inline void keep(contact<N, T>& c, contact<N, T>& found, component_set which) noexcept {
    for (; which != 0; which &= which - 1) {
        const int number = std::countr_zero(which);
        component(c, number) = component(found, number);
    }
}

// The encounter of two movers as a number, the stage that decided it, and the components of their contact that have
// been written.
struct further_contact {
    int what = undecided;
    stage decided_by = stage::double_word;
    component_set certain = 0;
};

// Of movers in unusual units, which the filter knows to meet: the contact by doubles.
template <moving B>
[[gnu::always_inline]] inline void contact_of_scaled(further_contact& r, contact<dimension_of<B>, double>& c,
                                                     const filtered_balls& f, const scaled_movers<B>& s, double mass_a,
                                                     double mass_b) noexcept {
    rounded_components<dimension_of<B>, double> taken{c};
    const double near = root_stable{}(f.c, f.h, plain_sqrt(std::fabs(f.discriminant)));
    if (contact_by_doubles(taken, f.what(), s.a, s.b, mass_a, mass_b, near)) {
        r.certain = scale_back(taken, s.length, s.velocity);
    }
}

// For movers in unusual units: by the filter and doubles, after scaling. Writes its answer where it is kept.
template <moving B>
[[gnu::noinline]] void contact_scaled(further_contact& r, contact<dimension_of<B>, double>& c, const B& a, const B& b,
                                      double mass_a, double mass_b) noexcept {
    if constexpr (has_error_free_doubles) {
        if (!rounds_to_nearest()) {
            return;
        }
        const auto decide = [&](const filtered_balls& f) {
            r.what = f.certain ? static_cast<int>(f.what()) : undecided;
            r.decided_by = stage::filter;
            return f.certain && is_collision(f.what());
        };
        if constexpr (is_flight<B>) {
            const scaled_movers<B> s = scaled(a, b);
            if (s.known) {
                if (const auto f = start_filter(s.a, s.b).finish(); decide(f)) {
                    contact_of_scaled(r, c, f, s, mass_a, mass_b);
                }
            }
        } else {
            const scaled_motion s(computed_motion(a, b), larger_radius(a, b));
            if (const auto f = filter_motion(s.motion); s.safe && decide(f)) {
                contact_of_scaled(r, c, f, s.scaled(a, b), mass_a, mass_b);
            }
        }
    }
}

// The normal and velocities of two balls that overlap, by scales of their own: the radii don't matter. Writes those of
// the wanted ones that are certain. To nearest.
template <int N>
[[nodiscard, gnu::noinline]] component_set overlap_by_distance(contact<N, double>& c, component_set wanted,
                                                               ball<N, double> a, ball<N, double> b, double mass_a,
                                                               double mass_b) noexcept {
    a.radius = b.radius = 0;
    const scaled_movers<ball<N, double>> s = scaled(a, b);
    if (!s.known) {
        return 0;
    }
    contact<N, double> found = zero_contact<N, double>{};
    rounded_components<N, double> taken{found};
    if (!contact_by_doubles(taken, encounter::overlap, s.a, s.b, mass_a, mass_b, 0)) {
        return 0;
    }
    if (mass_a == mass_b) {
        const auto exchanged = exchange_of_overlap(s.a, s.b);
        const auto take_open = [&](const bounded<double>& x, contact_component first, int i) {
            const int number = static_cast<int>(first) + i;
            if ((taken.certain >> number & 1U) == 0) {
                taken(x, number);
            }
        };
        for (int i = 0; i < N; ++i) {
            take_open(exchanged.a[i], contact_component::velocity_a, i);
            take_open(exchanged.b[i], contact_component::velocity_b, i);
        }
    }
    constexpr component_set positions =
        three_from(contact_component::position_a) | three_from(contact_component::position_b);
    const component_set certain = wanted & scale_back(taken, s.length, s.velocity) & ~positions & ~1U;
    keep(c, found, certain);
    return certain;
}

// Takes what words bound of a hit, and doubles of an overlap.
template <class Taker, moving B>
[[nodiscard, gnu::always_inline]] inline words_of_contact take_by_words(Taker& taken, const B& a, const B& b,
                                                                        double mass_a, double mass_b) noexcept {
    const auto& first = as_flight(a);
    const auto& second = as_flight(b);
    const words_of_contact w =
        with_best_products(contact_in_words<Taker, dimension_of<B>>{taken, first, second, mass_a, mass_b});
    if (w.what == static_cast<int>(encounter::overlap)) {
        (void)contact_by_doubles(taken, encounter::overlap, a, b, mass_a, mass_b, 0);
    }
    return w;
}

// In words: writes those of the wanted components that are certain. Of movers whose radii are not negative.
template <int N, class T, moving B>
[[nodiscard, gnu::noinline]] further_contact contact_by_words(contact<N, T>& c, component_set wanted, const B& a,
                                                              const B& b, double mass_a, double mass_b) noexcept {
    further_contact r;
    if constexpr (std::same_as<number_in<B>, float>) {
        return keeps_subnormals() ? contact_by_words(c, wanted, in_doubles(a), in_doubles(b), mass_a, mass_b) : r;
    } else if constexpr (has_error_free_doubles) {
        if (!rounds_to_nearest()) {
            return r;
        }
        if (has_usual_size(a, b)) {
            contact<N, T> found = zero_contact<N, T>{};
            rounded_components<N, T> taken{wanted == all_components ? c : found};
            const auto w = take_by_words(taken, a, b, mass_a, mass_b);
            r.what = w.what;
            r.certain = wanted & taken.certain;
            if (wanted != all_components) {
                keep(c, found, r.certain);
            }
            if (w.in_range) {
                return r;
            }
        }
        if constexpr (std::same_as<T, double>) { // floats are in range
            if (const scaled_movers<B> s = scaled(a, b); s.known) {
                contact<N, double> found = zero_contact<N, double>{};
                rounded_components<N, double> taken{wanted == all_components ? c : found};
                r.what = take_by_words(taken, s.a, s.b, mass_a, mass_b).what;
                r.certain = wanted & scale_back(taken, s.length, s.velocity);
                if (wanted != all_components) {
                    keep(c, found, r.certain);
                }
            }
        }
    }
    return r;
}

} // namespace graze::inline v0_1::detail
