// When, where and how two balls meet and leave, every number correctly rounded.
#pragma once

#include <graze/contact/exact_balls.hpp>
#include <graze/contact/fast_contact.hpp>
#include <graze/contact/word_contact.hpp>
#include <graze/predicate/classify_balls.hpp>

#include <cmath>
#include <concepts>
#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// By the bits: whether x is positive and finite.
[[nodiscard]] constexpr bool is_plain_mass(const double& x) noexcept {
    return bits_of(x) - 1 < 0x7ff0000000000000U - 1;
}
[[nodiscard]] constexpr bool is_plain_mass(const float& x) noexcept { return bits_of(x) - 1 < 0x7f800000U - 1; }

// Whether x is +∞, by its bits.
[[nodiscard]] constexpr bool is_infinite_mass(const double& x) noexcept { return bits_of(x) == 0x7ff0000000000000U; }
[[nodiscard]] constexpr bool is_infinite_mass(const float& x) noexcept { return bits_of(x) == 0x7f800000U; }

// Never constexpr, as reject.
[[noreturn]] inline void reject_infinite_masses(const char* a, const char* b) {
    throw std::domain_error(std::string(b) + ": mass is infinite, as that of " + a + " is");
}

template <class T>
constexpr void check_masses(const T& a, const T& b, const char* name_a = "ball a", const char* name_b = "ball b") {
    if (is_plain_mass(a) && is_plain_mass(b)) [[likely]] {
        return;
    }
    if (!is_plain_mass(a) && !is_infinite_mass(a)) {
        reject(name_a, "mass is not positive");
    }
    if (!is_plain_mass(b) && !is_infinite_mass(b)) {
        reject(name_b, "mass is not positive");
    }
    if (is_infinite_mass(a) && is_infinite_mass(b)) {
        reject_infinite_masses(name_a, name_b);
    }
}

// The mass as the formulas take it: 1 for an infinite one, and 0 beside it.
template <class U, class T>
[[nodiscard]] constexpr U effective_mass(const T& mass, const T& other) noexcept {
    return is_infinite_mass(mass) ? U(1) : is_infinite_mass(other) ? U(0) : static_cast<U>(mass);
}

// Rounds the wanted components of the contact of two balls that meet, by integers.
template <int N, class T>
[[gnu::noinline]] constexpr void complete(contact<N, T>& c, parts wanted, encounter what, const ball<N, T>& a,
                                          const ball<N, T>& b) {
    exact_workspace room;
    auto in = lift_row<two_balls<N>>(packed<two_balls<N>>(a, b));
    in.use(room);
    lifted<2> mass;
    const T masses[2] = {effective_mass<T>(a.mass, b.mass), effective_mass<T>(b.mass, a.mass)};
    lift(mass, masses);
    mass.room = &room;
    const auto vector = [](const auto& group, std::size_t from) {
        return make_vec<N>([&](int i) { return group.template get<big_integer>(from + static_cast<std::size_t>(i)); });
    };
    const auto motion = two_balls<N>::template motion<big_integer>(in);
    const exact_balls<N, std::remove_cvref_t<decltype(motion)>, big_integer, big_integer, big_integer> e{
        motion,
        vector(in.length, 0),
        vector(in.length, N),
        vector(in.velocity, 0),
        vector(in.velocity, N),
        mass.template get<big_integer>(0),
        mass.template get<big_integer>(1)};
    round_balls(c, wanted, what, e, {in.length.exponent, in.velocity.exponent, &room});
}

// What an overlap leaves as it is, and a ball whose mass is infinite or that is grazed.
template <int N, class T>
constexpr void keep_states(contact<N, T>& c, encounter what, const ball<N, T>& a, const ball<N, T>& b) noexcept {
    c.velocity_a = a.velocity;
    c.velocity_b = b.velocity;
    if (what == encounter::overlap) {
        c.position_a = with_plain_zeros(a.position);
        c.position_b = with_plain_zeros(b.position);
    }
}

// By double words, as far as they reach.
template <int N, class T>
void find_by_words(further_contact& r, const ball<N, T>& a, const ball<N, T>& b) noexcept {
    if (std::is_same_v<T, double> || keeps_subnormals()) {
        find_further_contact(r, in_doubles(a), in_doubles(b), effective_mass<double>(a.mass, b.mass),
                             effective_mass<double>(b.mass, a.mass));
    }
}

// The contact of two balls of which doubles leave open whether they meet.
template <int N, class T>
struct completed_contact {
    std::optional<contact<N, T>> what;
    stage decided_by;
};
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr completed_contact<N, T> collide_further(const ball<N, T>& a,
                                                                               const ball<N, T>& b) {
    std::optional<contact<N, T>> c;
    if (!std::is_constant_evaluated() && plain_radii(a.radius, b.radius)) {
        further_contact r;
        find_by_words(r, a, b);
        if (r.what != undecided) {
            const auto what = static_cast<encounter>(r.what);
            check_masses(a.mass, b.mass);
            if (!is_collision(what)) {
                return {std::nullopt, stage::double_word};
            }
            c.emplace();
            keep_states(*c, what, a, b);
            constexpr parts of_motion = 0x7fU; // time and positions
            const parts kept = what == encounter::overlap ? of_motion : 0;
            const parts certain = kept | round_components(*c, all_parts & ~kept, r.components, r.length, r.velocity);
            const parts open_parts = open_after(certain, *c, a, b, effective_mass<double>(a.mass, b.mass),
                                                effective_mass<double>(b.mass, a.mass));
            if (open_parts != 0) {
                complete(*c, open_parts, what, a, b);
            }
            return {c, open_parts != 0 ? stage::exact : stage::double_word};
        }
    }
    const encounter what = classify_exactly(a, b);
    check_masses(a.mass, b.mass);
    if (!is_collision(what)) {
        return {std::nullopt, stage::exact};
    }
    c.emplace();
    keep_states(*c, what, a, b);
    complete(*c, all_parts, what, a, b);
    return {c, stage::exact};
}

// Components that doubles have left open, of a hit or an overlap. Returns the stage.
template <int N, class T>
[[nodiscard, gnu::noinline]] stage complete_further(contact<N, T>& c, parts open_parts, encounter what,
                                                    const ball<N, T>& a, const ball<N, T>& b) {
    if (what == encounter::hit) {
        further_contact r;
        find_by_words(r, a, b);
        if (r.what == static_cast<int>(encounter::hit)) {
            open_parts &= ~round_components(c, open_parts, r.components, r.length, r.velocity);
        }
    }
    if (open_parts == 0) {
        return stage::double_word;
    }
    complete(c, open_parts, what, a, b);
    return stage::exact;
}

// The contact of two balls of which the filter is certain what becomes of them: no graze.
template <int N, class T, class Observer>
[[nodiscard]] constexpr std::optional<contact<N, T>> contact_of(const filtered_balls& f, const ball<N, T>& a,
                                                                const ball<N, T>& b, Observer&& observer) {
    check_masses(a.mass, b.mass);
    const encounter what = f.what();
    if (!is_collision(what)) {
        observer(stage::filter);
        return std::nullopt;
    }
    std::optional<contact<N, T>> c(std::in_place);
    if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest()) [[likely]] {
            const parts open_parts = fast_contact(*c, what, a, b, effective_mass<double>(a.mass, b.mass),
                                                  effective_mass<double>(b.mass, a.mass),
                                                  root_stable{}(f.c, f.h, std::sqrt(f.discriminant)));
            observer(open_parts == 0 ? stage::filter : complete_further(*c, open_parts, what, a, b));
            return c;
        }
    }
    keep_states(*c, what, a, b);
    complete(*c, all_parts, what, a, b);
    observer(stage::exact);
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
    if (!std::is_constant_evaluated() && detail::has_usual_size(a, b)) [[likely]] {
        if (const auto f = detail::filter_balls(a, b); f.certain) [[likely]] {
            return detail::contact_of(f, a, b, observer);
        }
    }
    auto further = detail::collide_further(a, b);
    observer(further.decided_by);
    return further.what;
}

} // namespace graze::inline v0_1
