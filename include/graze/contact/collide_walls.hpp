// When, where and how a ball meets a plane, a wall or a triangle and leaves it, every number correctly rounded.
#pragma once

#include <graze/contact/flat_contact.hpp>
#include <graze/contact/round_walls.hpp>
#include <graze/contact/wall_in_words.hpp>
#include <graze/machine/fused.hpp>
#include <graze/time/enclose_flat.hpp>

#include <concepts>
#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// Rounds the wanted components of a ball's contact with a plane or a wall that it meets, by integers.
template <class P, int N, class T, class Shape>
[[gnu::noinline]] constexpr void complete(P, wall_contact<N, T>& c, component_set wanted, encounter what, int index,
                                          const ball<N, T>& b, const Shape& shape) {
    exact_workspace room;
    auto in = lift_row<P>(packed<P>(b, shape));
    in.use(room);
    const scales units{in.length.exponent, in.velocity.exponent, &room};
    const auto motion = P::template motion<big_integer>(in);
    const auto position =
        make_vec<N>([&](int i) { return in.length.template get<big_integer>(static_cast<unsigned>(i)); });
    if constexpr (requires { shape.edge; }) {
        if (c.feature == feature::face) {
            round_face(c, wanted, what, face_of(motion), position, units);
            return;
        }
        if constexpr (N == 3) {
            if (c.feature == feature::edge) {
                round_edge(c, wanted, what, seen_from(motion, edge_view(index)), position, units);
                return;
            }
        }
        round_corner(c, wanted, what, seen_from(motion, wall_view{index, false}), position, units);
    } else {
        round_face(c, wanted, what, motion, position, units);
    }
}

// Times as they are, from the instant of the positions.
struct own_clock {
    [[nodiscard]] bounded_word operator()(const bounded_word& time) const noexcept { return time; }
    [[nodiscard]] bounded<double> operator()(const bounded<double>& time) const noexcept { return time; }
    // The components that integers have to round.
    template <class... Pair>
    [[nodiscard]] constexpr component_set without_time(auto&, component_set wanted, const Pair&...) const noexcept {
        return wanted;
    }
};

// Fills in the components of which doubles and double words are certain, for a pair that hits near `time` if that is
// not 0.
template <class P, int N, class T, class Shape, class Clock>
[[nodiscard]] component_set contact_by_words(P pair, wall_contact<N, T>& c, encounter what, int index,
                                             const ball<N, T>& b, const Shape& shape, double time,
                                             const Clock& clock) noexcept {
    component_set wanted = all_components;
    if (time > 0 || (std::is_same_v<Clock, own_clock> && what == encounter::overlap && c.feature == feature::face)) {
        const auto row = packed<P>(b, shape);
        const auto kind = kind_of<N>(pair, c.feature);
        wanted = with_best_products(flat_contact_near<N, T, Clock>{&c, kind, index, row.data(), time, &clock});
    }
    return wanted == 0 ? wanted : wanted & wall_in_words(pair, c, what, index, b, shape, clock);
}

// The contact of a ball whose encounter has been decided, near `time` if that is not 0.
template <class P, int N, class T, class Shape, class Observer, class Clock = own_clock>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>>
contact_of(P pair, const wall_encounter& found, stage decided_by, const ball<N, T>& b, const Shape& shape,
           Observer&& observer, const Clock& clock = {}, double time = 0) {
    if (!is_collision(found.what)) {
        observer(decided_by);
        return std::nullopt;
    }
    std::optional<wall_contact<N, T>> c(std::in_place);
    c->feature = found.where;
    c->index = found.index;
    const int number = number_in_wall<Shape>(found);
    const auto& whole = as_wall(shape);
    c->velocity = b.velocity;
    if (found.what == encounter::overlap) {
        c->position = with_plain_zeros(b.position);
    }
    component_set wanted = all_components;
    if constexpr (has_error_free_doubles) {
        if (!std::is_constant_evaluated() && rounds_to_nearest()) {
            wanted = contact_by_words(pair, *c, found.what, number, b, whole, time, clock);
        }
    }
    if (wanted != 0) {
        complete(pair, *c, clock.without_time(*c, wanted, found.what, number, pair, b, whole), found.what, number, b,
                 whole);
    }
    observer(wanted != 0 ? stage::exact : decided_by);
    return c;
}

template <int N, class T, class Shape, class Observer>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide_with(const ball<N, T>& b, const Shape& shape,
                                                                       Observer&& observer) {
    stage by{};
    const auto met = meet_flat(b, shape, by);
    return contact_of(pair_with<Shape>{}, {met.found.what, met.found.where, met.found.index}, by, b, shape, observer,
                      own_clock{}, met.bounds.near);
}

} // namespace detail

// The contact of a ball and an infinite plane, every component correctly rounded; empty when it recedes. The ball's
// mass does not matter. Throws as classify does. The observer is told `exact` if integers were needed for the decision
// or any component.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const ball<N, T>& b, const plane<N, T>& p,
                                                                  Observer&& observer = {}) {
    return detail::collide_with(b, p, observer);
}

// The contact of a ball and a wall or a triangle, at its face, an edge or a corner, whichever is met first; empty for
// recede and miss.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const ball<N, T>& b, const wall<N, T>& w,
                                                                  Observer&& observer = {}) {
    return detail::collide_with(b, w, observer);
}
template <std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<3, T>> collide(const ball<3, T>& b, const triangle<T>& t,
                                                                  Observer&& observer = {}) {
    return detail::collide_with(b, t, observer);
}

} // namespace graze::inline v0_1
