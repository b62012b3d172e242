// When, where and how two flights, or a flight and a plane or a wall, meet and leave, every number correctly rounded.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_walls.hpp>
#include <graze/contact/fast_flights.hpp>
#include <graze/time/time_of_flights.hpp>

namespace graze::inline v0_1 {

namespace detail {

// Rounds the wanted components of the contact of two flights that meet, by integers.
template <int N, class T>
[[gnu::noinline]] constexpr void complete(contact<N, T>& c, parts wanted, encounter what, const flight<N, T>& a,
                                          const flight<N, T>& b) {
    timed_workspace room;
    auto in = lift_flights(a, b);
    in.use(room);
    lifted<2> mass;
    const T masses[2] = {effective_mass<T>(a.state.mass, b.state.mass), effective_mass<T>(b.state.mass, a.state.mass)};
    lift(mass, masses);
    mass.room = &room;
    const scales units{in.pair.length.exponent, in.pair.velocity.exponent, &room};
    const auto pair = flights_in(in);
    const auto motion = pair.motion();
    const auto position_a = pair.position(pair.a);
    const auto position_b = pair.position(pair.b);
    if (what == encounter::overlap) {
        const auto rounded = [&](const big_integer& x) {
            return round_to<T>(x, big_integer(0), radicand<big_integer>(), big_integer(1), units.length);
        };
        fill(c.position_a, wanted, part::position_a, &room, [&](int i) { return rounded(position_a[i]); });
        fill(c.position_b, wanted, part::position_b, &room, [&](int i) { return rounded(position_b[i]); });
    }
    const exact_balls<N, std::remove_cvref_t<decltype(motion)>, big_integer, big_integer, big_integer> e{
        motion,
        position_a,
        position_b,
        pair.a.state.velocity,
        pair.b.state.velocity,
        mass.template get<big_integer>(0),
        mass.template get<big_integer>(1)};
    round_balls(c, wanted, what, e, units, from_earlier<big_integer>{pair.start()});
}

// The contact of two flights of which it has been decided what becomes of them; f: what the filter knows of them, which
// is certain of no graze.
template <int N, class T, class Observer>
[[nodiscard]] constexpr std::optional<contact<N, T>> contact_of(encounter what, stage decided_by,
                                                                const filtered_balls& f, const flight<N, T>& a,
                                                                const flight<N, T>& b, Observer&& observer) {
    check_masses(a.state.mass, b.state.mass, "flight a", "flight b");
    if (!is_collision(what)) {
        observer(decided_by);
        return std::nullopt;
    }
    std::optional<contact<N, T>> c(std::in_place);
    parts wanted = all_parts;
    if constexpr (has_error_free_doubles) {
        if (f.certain && what == encounter::hit && rounds_to_nearest()) [[likely]] {
            wanted = fast_contact(*c, a, b, effective_mass<double>(a.state.mass, b.state.mass),
                                  effective_mass<double>(b.state.mass, a.state.mass),
                                  root_stable{}(f.c, f.h, std::sqrt(f.discriminant)));
        }
    }
    if (wanted == all_parts) {
        c->velocity_a = a.state.velocity;
        c->velocity_b = b.state.velocity;
        if (what == encounter::overlap) {
            c->time = start_of<T>({a.since, b.since});
        }
    }
    if (wanted != 0) {
        complete(*c, wanted, what, a, b);
    }
    observer(wanted != 0 ? stage::exact : decided_by);
    return c;
}

// The clock of a flight's `since`.
template <class T>
struct clock_of_flight {
    const T& since;

    [[nodiscard]] bounded_word operator()(const bounded_word& time) const noexcept {
        return time + bounded_word(static_cast<double>(since));
    }
    [[nodiscard]] bounded<double> operator()(const bounded<double>& time) const noexcept {
        const auto sum = two_sum(static_cast<double>(since), time.high);
        return {sum.value, sum.error + time.low, 1.01 * time.error + 0x1p-104 * absolute(sum.value)};
    }
    // Rounds the time, if it is wanted, and returns what is left.
    template <class P, int N, class Shape>
    [[nodiscard]] constexpr parts without_time(wall_contact<N, T>& c, parts wanted, const wall_encounter& found, P pair,
                                               const ball<N, T>& b, const Shape& shape) const {
        if (has_time(wanted)) {
            const auto kind = std::is_same_v<P, ball_and_plane<N>> ? event_kind::plane : kind_of<N>(found.where);
            const flight_event<N, T> e(pair, b, shape, kind, found.index, false, since, since);
            c.time =
                found.what == encounter::overlap ? start_of<T>({since, since}) : round_exactly<T>(e, rounding::nearest);
        }
        return wanted & ~parts{1};
    }
};

} // namespace detail

// The contact of two flights, every component correctly rounded, its time on the clock of `since`; empty for recede and
// miss. Throws as classify does, and when a mass is not positive or both are infinite. The observer is told `exact` if
// integers were needed for the decision or any component.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<contact<N, T>> collide(const flight<N, T>& a, const flight<N, T>& b,
                                                             Observer&& observer = {}) {
    if (!std::is_constant_evaluated()) {
        if (const auto f = detail::filter_flights(a, b); f.certain) [[likely]] {
            return detail::contact_of(f.what(), stage::filter, f, a, b, observer);
        }
    }
    return detail::contact_of(detail::classify_exactly(a, b), stage::exact, {}, a, b, observer);
}

// The contact of a flight and an infinite plane; empty when it recedes. The mass has no part in it.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const flight<N, T>& f, const plane<N, T>& p,
                                                                  Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto met = detail::meet_flat(f.state, p, by);
    return detail::contact_of(detail::ball_and_plane<N>{}, {met.found.what, feature::face, 0}, by, f.state, p, observer,
                              detail::clock_of_flight<T>{f.since}, met.bounds.near);
}

// The contact of a flight and a wall, at its face, an edge or a corner, whichever is met first.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<wall_contact<N, T>> collide(const flight<N, T>& f, const wall<N, T>& w,
                                                                  Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto met = detail::meet_flat(f.state, w, by);
    return detail::contact_of(detail::ball_and_wall<N>{}, {met.found.what, met.found.where, met.found.index}, by,
                              f.state, w, observer, detail::clock_of_flight<T>{f.since}, met.bounds.near);
}

} // namespace graze::inline v0_1
