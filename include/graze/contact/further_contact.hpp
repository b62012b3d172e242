// The contact of two movers that plain doubles leave open: scaled if their units are unusual, then in double words.
#pragma once

#include <graze/contact/word_contact.hpp>
#include <graze/time/scaled_rounding.hpp>

#include <bit>

namespace graze::inline v0_1::detail {

// to[i] = from[i] 2^power for the wanted i where both are normal numbers; returns these.
template <int N>
[[nodiscard, gnu::always_inline]] inline component_set scale_back(vec<N, double>& to, const vec<N, double>& from,
                                                                  contact_component first, component_set wanted,
                                                                  int power) noexcept {
    component_set done = 0;
    for (int i = 0; i < N; ++i) {
        const int number = static_cast<int>(first) + i;
        const std::uint64_t bits = bits_of(from[i]);
        const int field = static_cast<int>(bits >> 52 & 0x7ff);
        const bool is_normal = field != 0 && 0 < field + power && field + power < 0x7ff;
        if (is_normal && (wanted >> number & 1U) != 0) {
            to[i] = std::bit_cast<double>(bits + (static_cast<std::uint64_t>(std::int64_t{power}) << 52));
            done |= component_set{1} << number;
        }
    }
    return done;
}

// The same for all components, from units of lengths and velocities of 2^length and 2^velocity.
template <int N>
[[nodiscard]] component_set scale_back(contact<N, double>& c, const rounded_components<N, double>& x,
                                       component_set wanted, int length, int velocity) noexcept {
    wanted &= x.certain;
    component_set done = scale_back(c.position_a, x.c.position_a, contact_component::position_a, wanted, length) |
                         scale_back(c.position_b, x.c.position_b, contact_component::position_b, wanted, length) |
                         scale_back(c.normal, x.c.normal, contact_component::normal, wanted, 0) |
                         scale_back(c.velocity_a, x.c.velocity_a, contact_component::velocity_a, wanted, velocity) |
                         scale_back(c.velocity_b, x.c.velocity_b, contact_component::velocity_b, wanted, velocity);
    if (has_time(wanted)) {
        if (const auto time = rounded_quickly<double>(x.time, length - velocity)) {
            c.time = *time;
            done |= 1;
        }
    }
    return done;
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
    contact<dimension_of<B>, double> found = zero_contact<dimension_of<B>, double>{};
    rounded_components<dimension_of<B>, double> taken{found};
    const double near = root_stable{}(f.c, f.h, plain_sqrt(std::fabs(f.discriminant)));
    if (contact_by_doubles(taken, f.what(), s.a, s.b, mass_a, mass_b, near)) {
        r.certain = scale_back(c, taken, all_components, s.length, s.velocity);
    }
}

// For movers in unusual units: by the filter and doubles, after scaling.
template <moving B>
[[nodiscard, gnu::noinline]] further_contact contact_scaled(contact<dimension_of<B>, double>& c, const B& a, const B& b,
                                                            double mass_a, double mass_b) noexcept {
    further_contact r;
    if constexpr (has_error_free_doubles) {
        if (!rounds_to_nearest()) {
            return r;
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
    return r;
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
    return scale_back(c, taken, wanted & ~positions & ~1U, s.length, s.velocity);
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
                for (component_set rest = r.certain; rest != 0; rest &= rest - 1) {
                    const int number = std::countr_zero(rest);
                    component(c, number) = component(found, number);
                }
            }
            if (w.in_range) {
                return r;
            }
        }
        if constexpr (std::same_as<T, double>) { // floats are in range
            if (const scaled_movers<B> s = scaled(a, b); s.known) {
                contact<N, double> found = zero_contact<N, double>{};
                rounded_components<N, double> taken{found};
                r.what = take_by_words(taken, s.a, s.b, mass_a, mass_b).what;
                r.certain = scale_back(c, taken, wanted, s.length, s.velocity);
            }
        }
    }
    return r;
}

} // namespace graze::inline v0_1::detail
