// When two things meet first, if they do.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/time/further_time.hpp>
#include <graze/time/impact_time.hpp>

#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// The time of an event with the enclosure that its exact quadratic gives.
template <int N, class T>
[[nodiscard]] constexpr impact_time<N, T> enclosed_exactly(event<N, T> e) {
    constexpr impact_time_key key{};
    if (e.overlap) {
        return impact_time<N, T>(key, enclosure{0, 0}, e);
    }
    if (std::is_constant_evaluated()) {
        return impact_time<N, T>(key, enclosure{}, e);
    }
    const enclosure bounds = with_pair<N>(e.kind, [&]<class P>(P) {
        const auto inputs = lift_row<P>(e.row);
        const int unit = inputs.length.exponent - inputs.velocity.exponent;
        return with_exact_motion<P>(inputs, [&](const auto& m) {
            return with_quadratic<N, P>(e.kind, e.index, m, [&](const auto& q) { return enclose(q, unit); });
        });
    });
    e.overlap = bounds.is_zero(); // they touch
    return impact_time<N, T>(key, bounds, e);
}

// Of two balls that overlap.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr std::optional<impact_time<N, T>> time_of_overlap(const ball<N, T>& a,
                                                                                        const ball<N, T>& b) {
    return std::optional<impact_time<N, T>>(std::in_place, impact_time_key{}, enclosure{0, 0}, two_balls<N>{}, a, b,
                                            event_kind::balls, 0, true);
}

// The time of two balls of which the filter is not certain, or is certain that they hit but not closely enough when.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr std::optional<impact_time<N, T>> time_of_impact_exactly(const ball<N, T>& a,
                                                                                               const ball<N, T>& b) {
    const encounter what = classify_exactly(a, b);
    if (!is_collision(what)) {
        return std::nullopt;
    }
    return enclosed_exactly(event<N, T>(two_balls<N>{}, a, b, event_kind::balls, 0, what == encounter::overlap));
}

// An enclosure around a time in units of 2^unit that is further rounded to `nearest`, unknown beyond 2^±900.
[[nodiscard]] inline enclosure enclosure_of(const further_time& t, double nearest) noexcept {
    const double near = absolute(nearest);
    if (!within_powers<-900, 900>(near)) {
        return {nearest, enclosure::unknown};
    }
    return {nearest, 0x1p-49 * near + (t.unit == 0 ? t.time.error : 0)};
}

// The same by double words as far as they reach. Time and stage.
template <int N, class T>
struct further_impact {
    std::optional<impact_time<N, T>> time;
    stage decided_by;
};
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr further_impact<N, T> time_of_impact_further(const ball<N, T>& a,
                                                                                   const ball<N, T>& b) {
    if constexpr (std::is_floating_point_v<T>) {
        if (!std::is_constant_evaluated() && plain_radii(a.radius, b.radius)) {
            const further_time t = find_further_time(a, b);
            if (t.what == static_cast<int>(encounter::recede) || t.what == static_cast<int>(encounter::miss)) {
                return {std::nullopt, stage::double_word};
            }
            if (t.what == static_cast<int>(encounter::overlap)) {
                return {time_of_overlap(a, b), stage::double_word};
            }
            if (t.what == static_cast<int>(encounter::hit)) {
                if (const auto nearest = round_further_time<double>(t, rounding::nearest);
                    nearest && is_finite_input(*nearest)) {
                    event<N, T> e(two_balls<N>{}, a, b, event_kind::balls, 0, false);
                    e.nearest = std::is_same_v<T, double>;
                    return {impact_time<N, T>(impact_time_key{}, enclosure_of(t, *nearest), e), stage::double_word};
                }
            }
        }
    }
    return {time_of_impact_exactly(a, b), stage::exact};
}

} // namespace detail

// Laws 1 to 6 of classify_balls.hpp, and
//   9. a larger ball is met no later.

// The exact time at which two balls touch first; empty for recede and miss. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<impact_time<N, T>>
time_of_impact(const ball<N, T>& a, const ball<N, T>& b, Observer&& observer = {}) {
    if (!std::is_constant_evaluated()) {
        if (!detail::has_usual_size(a, b)) [[unlikely]] {
            auto further = detail::time_of_impact_further(a, b);
            observer(further.decided_by);
            return further.time;
        }
        // Half of all pairs part; of the others a hit takes one branch, since what else is asked never differs.
        const auto started = detail::start_filter(a, b);
        if (started.is_parting()) {
            observer(stage::filter);
            return std::nullopt;
        }
        if (const auto hit = started.find_clear_hit(); hit.certain) {
            observer(stage::filter);
            // error_root/a is at most (K_D + K_h) length²: √D <= |h| <= length·velocity.
            using constant = detail::ball_filter<N, T>;
            static_assert(started.clear * constant::discriminant >= 8 * (constant::discriminant + constant::h));
            constexpr double error = 1.5 * (constant::c + constant::discriminant + constant::h);
            const auto bounds = detail::enclose(started.q.c, started.q.h, hit.discriminant, error * started.length2);
            if (detail::has_error_free_doubles || bounds.is_known()) [[likely]] {
                return std::optional<impact_time<N, T>>(std::in_place, detail::impact_time_key{}, bounds,
                                                        detail::two_balls<N>{}, a, b, detail::event_kind::balls, 0,
                                                        false);
            }
            return detail::time_of_impact_further(a, b).time;
        }
        if (const auto f = started.finish(); f.certain) {
            observer(stage::filter);
            const encounter what = f.what();
            if (!is_collision(what)) { // balls that part as well, of which x87 may be certain only now
                return std::nullopt;
            }
            if (what == encounter::overlap) {
                return detail::time_of_overlap(a, b);
            }
            return detail::time_of_impact_further(a, b).time; // nearly a graze
        }
    }
    auto further = detail::time_of_impact_further(a, b);
    observer(further.decided_by);
    return further.time;
}

} // namespace graze::inline v0_1
