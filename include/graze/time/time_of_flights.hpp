// When two flights, or a flight and a plane or a wall, meet first, if they do.
#pragma once

#include <graze/predicate/classify_flights.hpp>
#include <graze/time/flight_time.hpp>
#include <graze/time/time_of_walls.hpp>

#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// The time of an event with the enclosure that its exact quadratic gives.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr flight_time<N, T> enclosed_exactly(flight_event<N, T> e) {
    constexpr impact_time_key key{};
    if (std::is_constant_evaluated()) {
        return flight_time<N, T>(key, timed_enclosure{}, e);
    }
    const auto start = static_cast<double>(e.start());
    if (!e.pair.overlap) {
        const enclosure bounds = with_timed_inputs(e, [&]<class In, class P>(In in, P) {
            const int unit = in.unit();
            in.settle(unit);
            timed_workspace room;
            in.use(room);
            return with_timed_motion<N, P>(in, [&](const auto& m, const auto&) {
                return with_quadratic<N, P>(e.pair.kind, e.pair.index, m,
                                            [&](const auto& q) { return enclose(q, unit); });
            });
        });
        e.pair.overlap = bounds.is_zero(); // they touch
        if (!e.pair.overlap) {
            return flight_time<N, T>(key, counted_from<T>(start, bounds), e);
        }
    }
    return flight_time<N, T>(key, timed_enclosure{start, start}, e);
}

// From the later start on, of flights that meet and of which the filter is certain; perhaps unknown. error_root/a is at
// most (K_D + 3/2 K_h) length²: √D <= |h| <= √2 length·velocity, with the filter's length.
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline enclosure enclosure_of_flights(const filtered_balls& f,
                                                                        encounter what) noexcept {
    using constant = flight_filter<N, T>;
    constexpr double root = constant::discriminant + 1.5 * constant::h;
    return what != encounter::overlap && f.discriminant > 8 * root * f.scale
               ? enclose(f.c, f.h, f.discriminant, 1.5 * (constant::c + root) * f.length2)
               : enclosure{};
}

template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr std::optional<flight_time<N, T>> time_of_impact_exactly(const flight<N, T>& a,
                                                                                               const flight<N, T>& b) {
    const encounter what = classify_exactly(a, b);
    if (!is_collision(what)) {
        return std::nullopt;
    }
    return enclosed_exactly(flight_event<N, T>(two_balls<N>{}, a.state, b.state, event_kind::balls, 0,
                                               what == encounter::overlap, a.since, b.since));
}

// The time of an event of a flight and a plane or a wall that happens within the bounds, if these are known, after the
// flight's since.
template <int N, class T>
[[nodiscard]] constexpr flight_time<N, T> with_clock(const flight_event<N, T>& e, const enclosure& bounds) {
    if (bounds.is_known()) [[likely]] {
        return flight_time<N, T>(impact_time_key{}, counted_from<T>(static_cast<double>(e.start()), bounds), e);
    }
    return enclosed_exactly(e);
}

} // namespace detail

// The exact time, not before both are on their way, at which two flights touch first; empty for recede and miss, t0 for
// an overlap. Throws as classify does. Laws 1 to 6, 12 and 13.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<flight_time<N, T>>
time_of_impact(const flight<N, T>& a, const flight<N, T>& b, Observer&& observer = {}) {
    if (!std::is_constant_evaluated()) {
        if (const auto f = detail::filter_flights(a, b); f.certain) [[likely]] {
            observer(stage::filter);
            const encounter what = f.what();
            if (!is_collision(what)) {
                return std::nullopt;
            }
            const auto bounds = detail::enclosure_of_flights<N, T>(f, what);
            if (bounds.is_known()) [[likely]] {
                const auto start = static_cast<double>(detail::as_stored(a.since < b.since ? b.since : a.since));
                return std::optional<flight_time<N, T>>(
                    std::in_place, detail::impact_time_key{}, detail::counted_from<T>(start, bounds),
                    detail::two_balls<N>{}, a.state, b.state, detail::event_kind::balls, 0, false, a.since, b.since);
            }
            return detail::time_of_impact_exactly(a, b);
        }
    }
    auto time = detail::time_of_impact_exactly(a, b);
    observer(stage::exact);
    return time;
}

// The exact time at which a flight touches a plane first; empty when it recedes.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<flight_time<N, T>> time_of_impact(const flight<N, T>& f, const plane<N, T>& p,
                                                                        Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto [found, bounds] = detail::meet_flat(f.state, p, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    return detail::with_clock(detail::flight_event<N, T>(detail::ball_and_plane<N>{}, f.state, p,
                                                         detail::event_kind::plane, 0, found.what == encounter::overlap,
                                                         f.since, f.since),
                              bounds);
}

// The exact time at which a flight touches a wall's face, edge or corner first; empty for recede and miss.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<flight_time<N, T>> time_of_impact(const flight<N, T>& f, const wall<N, T>& w,
                                                                        Observer&& observer = {}) {
    detail::check(f, "flight");
    stage by{};
    const auto [found, bounds] = detail::meet_flat(f.state, w, by);
    observer(by);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    return detail::with_clock(detail::flight_event<N, T>(detail::ball_and_wall<N>{}, f.state, w,
                                                         detail::kind_of<N>(found), found.index,
                                                         found.what == encounter::overlap, f.since, f.since),
                              bounds);
}

} // namespace graze::inline v0_1
