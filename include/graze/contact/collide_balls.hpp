// When, where and how two balls or two flights meet and leave, every number correctly rounded.
#pragma once

#include <graze/contact/exact_balls.hpp>
#include <graze/contact/further_contact.hpp>
#include <graze/predicate/classify_balls.hpp>

#include <cmath>
#include <concepts>
#include <optional>

namespace graze::inline v0_1 {

namespace detail {

template <moving B>
using contact_of_movers = contact<dimension_of<B>, number_in<B>>;

// As the formulas take them, in doubles.
template <moving B>
[[nodiscard]] constexpr double mass_in_doubles(const B& of, const B& beside) noexcept {
    return effective_mass<double>(state_of(of).mass, state_of(beside).mass);
}
template <moving B>
constexpr void check_masses_of(const B& a, const B& b) {
    if (!is_plain_mass(state_of(a).mass) || !is_plain_mass(state_of(b).mass)) [[unlikely]] {
        inspect_masses(a, b, rejecting{name_of_a<B>}, rejecting{name_of_b<B>});
    }
}

// The components of a hit or an overlap that doubles left open, by words and integers. Returns the stage.
template <moving B>
[[nodiscard, gnu::noinline]] stage complete_further(contact_of_movers<B>& c, component_set open_components,
                                                    encounter what, const B& a, const B& b) {
    const double mass_a = mass_in_doubles(a, b);
    const double mass_b = mass_in_doubles(b, a);
    if (what == encounter::hit) {
        open_components &= ~contact_by_words(c, open_components, a, b, mass_a, mass_b).certain;
    } else if constexpr (has_error_free_doubles && std::same_as<B, ball<dimension_of<B>, double>>) {
        if (rounds_to_nearest()) {
            open_components &= ~overlap_by_distance(c, open_components, a, b, mass_a, mass_b);
        }
    }
    if (open_components == 0) {
        return stage::double_word;
    }
    complete(c, open_components, what, a, b);
    return stage::exact;
}

// By integers alone.
template <moving B>
constexpr void complete_all(contact_of_movers<B>& c, encounter what, const B& a, const B& b) {
    using T = number_in<B>;
    const auto& x = state_of(a);
    const auto& y = state_of(b);
    const component_set given =
        set_given(c, what, a, b, effective_mass<T>(x.mass, y.mass), effective_mass<T>(y.mass, x.mass));
    complete(c, all_components & ~given, what, a, b);
}

// The functions that return a contact either return one variable, which is then made where it is returned, or what
// another function returns: a copy would wait for its parts.
template <moving B>
using optional_contact = std::optional<contact_of_movers<B>>;
template <moving B>
using zeros_of = zero_contact<dimension_of<B>, number_in<B>>;

// In unusual units scaled, then in words. What these leave open in c has any value.
template <moving B>
[[nodiscard, gnu::always_inline]] inline further_contact start_further(contact_of_movers<B>& c, const B& a, const B& b,
                                                                       double mass_a, double mass_b) noexcept {
    if constexpr (std::same_as<number_in<B>, double>) {
        if (!has_usual_size(a, b)) {
            further_contact r;
            contact_scaled(r, c, a, b, mass_a, mass_b);
            if (r.what != undecided) {
                return r;
            }
        }
    }
    return contact_by_words(c, all_components, a, b, mass_a, mass_b);
}

// The contact of two movers whose encounter the filter leaves open. `by` becomes the stage.
template <moving B>
[[nodiscard, gnu::noinline]] constexpr optional_contact<B> collide_further(const B& a, const B& b, stage& by) {
    optional_contact<B> c(std::in_place, zeros_of<B>{});
    if (rest_together(a, b)) {
        check_masses_of(a, b);
        by = stage::filter;
        c.reset();
        return c;
    }
    if (!std::is_constant_evaluated() && plain_radii(state_of(a).radius, state_of(b).radius)) {
        const double mass_a = mass_in_doubles(a, b);
        const double mass_b = mass_in_doubles(b, a);
        const further_contact r = start_further(*c, a, b, mass_a, mass_b);
        if (r.what != undecided) {
            const auto what = static_cast<encounter>(r.what);
            check_masses_of(a, b);
            by = r.decided_by;
            if (!is_collision(what)) {
                c.reset();
                return c;
            }
            const component_set open_components = open_after(r.certain, *c, what, a, b, mass_a, mass_b);
            if (open_components == 0) {
                return c;
            }
            if (by == stage::filter || what == encounter::overlap) {
                by = complete_further(*c, open_components, what, a, b);
            } else {
                complete(*c, open_components, what, a, b);
                by = stage::exact;
            }
            return c;
        }
    }
    by = stage::exact;
    const encounter what = classify_exactly(a, b, open_number{});
    check_masses_of(a, b);
    if (is_collision(what)) {
        complete_all(*c, what, a, b);
    } else {
        c.reset();
    }
    return c;
}

// The contact of two movers that the filter knows to hit or to overlap, by doubles first. `by` becomes the stage.
template <moving B>
[[nodiscard, gnu::always_inline]] constexpr inline optional_contact<B>
contact_of_filtered(const filtered_balls& f, const B& a, const B& b, stage& by) {
    optional_contact<B> c(std::in_place, zeros_of<B>{});
    const encounter what = f.what();
    if constexpr (has_error_free_doubles) {
        if (suits_contacts<number_in<B>>()) [[likely]] {
            const component_set open_components =
                contact_in_doubles(*c, what, a, b, mass_in_doubles(a, b), mass_in_doubles(b, a),
                                   root_stable{}(f.c, f.h, std::sqrt(f.discriminant)));
            by = open_components == 0 ? stage::filter : complete_further(*c, open_components, what, a, b);
            return c;
        }
    }
    complete_all(*c, what, a, b);
    by = stage::exact;
    return c;
}

template <moving B>
[[nodiscard]] constexpr optional_contact<B> collide_movers(const B& a, const B& b, stage& by) {
    if (!std::is_constant_evaluated() && has_usual_size(a, b)) [[likely]] {
        if (const auto f = start_filter(a, b, true).finish(); f.certain) [[likely]] {
            check_masses_of(a, b);
            if (!is_collision(f.what())) {
                by = stage::filter;
                return std::nullopt;
            }
            return contact_of_filtered(f, a, b, by);
        }
    }
    return collide_further(a, b, by);
}
template <moving B, class Observer>
[[nodiscard, gnu::always_inline]] constexpr inline optional_contact<B> collide_observed(const B& a, const B& b,
                                                                                        Observer&& observer) {
    stage by = stage::exact;
    auto c = collide_movers(a, b, by);
    observer(by);
    return c;
}

} // namespace detail

// The contact of two balls, every component correctly rounded; empty for recede and miss. Throws as classify does, and
// when a mass is not positive or both are infinite. The observer is told `exact` if integers were needed for the
// decision or any component.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<contact<N, T>> collide(const ball<N, T>& a, const ball<N, T>& b,
                                                             Observer&& observer = {}) {
    return detail::collide_observed(a, b, observer);
}

// The contact of two flights, its time on the clock of `since`.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<contact<N, T>> collide(const flight<N, T>& a, const flight<N, T>& b,
                                                             Observer&& observer = {}) {
    return detail::collide_observed(a, b, observer);
}

} // namespace graze::inline v0_1
