// When two things meet first, if they do.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>
#include <graze/predicate/impact_time.hpp>

#include <optional>

namespace graze {

namespace detail {

template <int N, class T>
[[nodiscard]] constexpr impact_time<N, T> make_time(const event<N, T>& e, const enclosure& bounds) noexcept {
    return impact_time_access<N, T>::make(e, bounds);
}

// An event with the enclosure that its exact quadratic gives.
template <int N, class T>
[[nodiscard]] constexpr impact_time<N, T> enclosed_exactly(const event<N, T>& e) {
    if (e.overlap) {
        return make_time(e, {0, 0});
    }
    if (std::is_constant_evaluated()) {
        return make_time(e, {});
    }
    return make_time(e, with_pair<N>(e.kind, [&]<class P>(P) {
                         const auto inputs = lift_row<P>(e.row);
                         const int unit = inputs.length.exponent - inputs.velocity.exponent;
                         return with_exact_motion<P>(inputs, [&](const auto& m) {
                             return with_quadratic<N, P>(e.kind, e.index, m,
                                                         [&](const auto& q) { return enclose(q, unit); });
                         });
                     }));
}

} // namespace detail

// The exact time at which two balls touch first; empty for recede and miss. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const ball<N, T>& a, const ball<N, T>& b,
                                                                        Observer&& observer = {}) {
    const auto event = [&](encounter what) {
        return detail::make_event<N, T>(two_balls<N>::pack(a, b), detail::event_kind::balls, 0,
                                        what == encounter::overlap);
    };
    if (!std::is_constant_evaluated()) {
        if (const auto f = detail::filter_balls(a, b); f.certain) {
            observer(stage::filter);
            const encounter what = f.what();
            if (!is_collision(what)) {
                return std::nullopt;
            }
            if (what == encounter::overlap) {
                return detail::make_time(event(what), {0, 0});
            }
            using constant = detail::ball_filter<N, T>;
            const auto bounds = detail::enclose(f.c, f.h, f.discriminant, constant::c * f.length2,
                                                (constant::discriminant + constant::h) * f.scale);
            if (bounds.upper < detail::enclosure::unknown) [[likely]] {
                return detail::make_time(event(what), bounds);
            }
            return detail::enclosed_exactly(event(what));
        }
    }
    observer(stage::exact);
    const encounter what = detail::with_exact_balls(a, b, detail::exact_encounter{});
    return is_collision(what) ? std::optional(detail::enclosed_exactly(event(what))) : std::nullopt;
}

// The exact time at which a ball touches a plane first; empty when it recedes. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const ball<N, T>& b, const plane<N, T>& p,
                                                                        Observer&& observer = {}) {
    const encounter what = classify(b, p, observer);
    if (!is_collision(what)) {
        return std::nullopt;
    }
    return detail::enclosed_exactly(detail::make_event<N, T>(ball_and_plane<N>::pack(b, p), detail::event_kind::plane,
                                                             0, what == encounter::overlap));
}

// The exact time at which a ball touches a wall's face, edge or corner first; empty for recede and miss. Throws as
// classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<impact_time<N, T>> time_of_impact(const ball<N, T>& b, const wall<N, T>& w,
                                                                        Observer&& observer = {}) {
    const wall_encounter found = detail::decide_wall(b, w, observer);
    if (!is_collision(found.what)) {
        return std::nullopt;
    }
    return detail::enclosed_exactly(detail::make_event<N, T>(
        ball_and_wall<N>::pack(b, w), detail::kind_of<N>(found.where), found.index, found.what == encounter::overlap));
}

} // namespace graze
