// A run in floats or doubles in which every decision is exact and every number correctly rounded.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_flights.hpp>
#include <graze/contact/collide_images.hpp>
#include <graze/exact/dyadic.hpp>
#include <graze/predicate/signs_of_face.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/time/bounds_of_image.hpp>
#include <graze/time/bounds_until.hpp>

#include <limits>
#include <stdexcept>

namespace graze::inline v0_1 {

// Which bodies meet, and in which order, is exact for the states as they are. A state after an event is the exact one,
// rounded once. Between two events of a ball nothing is rounded. Throws std::overflow_error when a state would be
// beyond the largest T.
template <int N, std::floating_point T = double>
requires is_binary_input<T>
struct exact_mechanics {
    static constexpr int dimension = N;
    using number = T;
    using state = flight<N, T>;
    using time = impact_time<N, T>;
    using exact = dyadic;
    static constexpr bool rounds = true;

    [[nodiscard]] constexpr state start(const ball<N, T>& b) const { return {b, T(0)}; }

    template <class S>
    [[nodiscard]] constexpr std::optional<time> meet(const state& a, const S& other) const {
        return time_of_impact(a, other);
    }

    [[nodiscard, gnu::always_inline]] time_bounds meet_until(const state& a, const state& b, double latest) const {
        const detail::enclosure found = detail::bounds_until(a, b, latest);
        return {found.lower(), found.upper()};
    }
    [[nodiscard]] constexpr wall_encounter feature(const state& a, const triangle<T>& t) const requires(N == 3) {
        return classify_feature(a, t);
    }

    // In a space with periods. Throws std::range_error where a coordinate is so small beside a period that its distance
    // from an image is no difference of two T, or where numbers T cannot hold a wall's image.
    constexpr std::array<std::int32_t, 3> wrap(state& a, const vec<N, T>& period) const {
        return bring_within(a.state.position, period);
    }
    [[nodiscard]] constexpr std::optional<time> meet(const state& a, const state& b,
                                                     const image_shift<N, T>& image) const {
        const detail::stand_ins<N, T> pair(a, b, image);
        return time_of_impact(pair.a, pair.b);
    }
    [[nodiscard]] time_bounds meet_until(const state& a, const state& b, const image_shift<N, T>& image,
                                         double latest) const {
        const detail::enclosure found = detail::bounds_of_image(a, b, image, latest);
        return {found.lower(), found.upper()};
    }
    constexpr void bounce(state& a, state& b, const image_shift<N, T>& image, const time&) const {
        const contact<N, T> c = *detail::collide_image(a, b, image);
        leave(a, c.time, c.position_a, c.velocity_a);
        leave(b, c.time, c.position_b, c.velocity_b);
    }
    // A wall or a triangle.
    template <class W>
    requires requires(const W& w) { w.edge; }
    [[nodiscard]] W displaced(W w, const image_shift<N, T>& image) const { return detail::displaced_exactly(w, image); }

    [[nodiscard]] constexpr int order(const time& s, const time& t) const { return s.compare(t); }
    [[nodiscard]] constexpr int order(const time& s, const T& t) const { return s < t ? -1 : s > t ? 1 : 0; }
    // The enclosure that the time was made with. If it is too wide to be of use, the exact time, rounded both ways.
    [[nodiscard]] constexpr time_bounds bounds(const time& t) const {
        const detail::enclosure near = t.enclosure();
        if (near.error <= near.near * 0x1p-31) {
            return {near.lower(), near.upper()};
        }
        return {static_cast<double>(t.lower()), static_cast<double>(t.upper())};
    }
    // As the time of two balls that touch then.
    [[nodiscard]] constexpr time now(const state& a) const {
        ball<N, T> approaching{};
        approaching.position[0] = T(-1);
        approaching.velocity[0] = T(1);
        return detail::enclosed_exactly(detail::event<N, T>(detail::two_balls<N>{}, state{approaching, a.since},
                                                            state{ball<N, T>{}, a.since}, detail::event_kind::balls, 0,
                                                            true));
    }
    [[nodiscard]] constexpr flight<N, double> about(const state& a) const {
        const auto wide = [](const vec<N, T>& x) {
            return make_vec<N>([&](int i) { return static_cast<double>(x[i]); });
        };
        return {{wide(a.state.position), wide(a.state.velocity), static_cast<double>(a.state.radius),
                 static_cast<double>(a.state.mass)},
                static_cast<double>(a.since)};
    }

    [[nodiscard]] bool set_back(state& a, const T& by) const {
        const T since = a.since - by;
        if (!detail::is_finite_input(since) || !(dyadic(since) == dyadic(a.since) - dyadic(by))) {
            return false;
        }
        a.since = since;
        return true;
    }

    [[nodiscard]] exact as_exact(const T& x) const { return exact(x); }

    [[nodiscard]] constexpr bool immovable(const state& a) const { return detail::is_infinite_mass(a.state.mass); }
    [[nodiscard]] constexpr bool is_point(const state& a) const { return detail::is_zero(a.state.radius); }

    constexpr void bounce(state& a, state& b, const time&) const {
        const contact<N, T> c = *collide(a, b);
        leave(a, c.time, c.position_a, c.velocity_a);
        leave(b, c.time, c.position_b, c.velocity_b);
    }
    template <class S>
    constexpr void bounce(state& a, const S& standing, const time&) const {
        const wall_contact<N, T> c = *collide(a, standing);
        leave(a, c.time, c.position, c.velocity);
    }

    template <class S>
    [[nodiscard]] constexpr int side(const state& a, const S& standing) const {
        return detail::side_of(a.state, standing);
    }
    template <class S>
    [[nodiscard]] constexpr int heading(const state& a, const S& standing) const {
        return detail::heading_of(a.state, standing);
    }
    template <class S>
    [[nodiscard]] constexpr time reach(const state& a, const S& standing) const {
        using pair = detail::pair_with<S>;
        return detail::enclosed_exactly(
            detail::event<N, T>(pair{}, a, standing, detail::kind_of<N>(pair{}, graze::feature::face), 0, false));
    }
    // As for a ball that cuts the face and goes deeper.
    template <class S>
    constexpr void turn_back(state& a, const S& standing) const {
        using pair = detail::pair_with<S>;
        constexpr wall_encounter inside{encounter::overlap, graze::feature::face, 0};
        const auto c = detail::contact_of(pair{}, inside, stage::exact, a.state, standing, ignore_stage{},
                                          detail::clock_of_flight<T>{a.since});
        leave(a, a.since, a.state.position, c->velocity);
    }

  private:
    constexpr void leave(state& a, const T& since, const vec<N, T>& position, const vec<N, T>& velocity) const {
        if (immovable(a)) {
            return;
        }
        if (!detail::is_finite_input(since) || !detail::is_finite(position) || !detail::is_finite(velocity)) {
            throw std::overflow_error("the state after the event is beyond the largest number");
        }
        a.since = since;
        a.state.position = position;
        a.state.velocity = velocity;
    }
};

} // namespace graze::inline v0_1
