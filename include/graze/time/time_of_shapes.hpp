// When two things meet first, if they do.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/time/time_of_hard_movers.hpp>

#include <optional>

namespace graze::inline v0_1 {

namespace detail {

// From their start on, for two movers that hit clearly. error_root/a is at most (K_D + 3/2 K_h) length²: √D <= |h| <=
// √2 length·velocity, for balls without the √2.
template <moving B, class Started>
[[nodiscard, gnu::always_inline]] inline enclosure enclosure_from_start(const Started& started,
                                                                        double discriminant) noexcept {
    using constant = filter_of<B>;
    constexpr double root = constant::discriminant + (is_flight<B> ? 1.5 : 1) * constant::h;
    static_assert(Started::clear * constant::discriminant >= 8 * root);
    return enclose(started.q.c, started.q.h, discriminant, 1.5 * (constant::c + root) * started.length2);
}

template <moving B, class Observer>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<time_of_movers<B>> time_of_two(const B& a, const B& b,
                                                                                                Observer&& observer) {
    using T = number_in<B>;
    if (!std::is_constant_evaluated()) {
        if (!has_usual_size(a, b)) [[unlikely]] {
            return tell_further<false>(a, b, observer);
        }
        // Half of all pairs part; of the others a hit takes one branch, since the other conditions never differ.
        const auto started = start_filter(a, b, true);
        if (started.is_parting()) {
            observer(stage::filter);
            return std::nullopt;
        }
        if (const auto hit = started.find_clear_hit(); hit.certain) {
            observer(stage::filter);
            const enclosure from_start = enclosure_from_start<B>(started, hit.discriminant);
            if (has_error_free_doubles || from_start.is_known()) [[likely]] {
                enclosure bounds = from_start;
                if constexpr (is_flight<B>) {
                    const T& start = as_stored(a.since) < as_stored(b.since) ? b.since : a.since;
                    bounds = counted_from<T>(static_cast<double>(as_stored(start)), from_start);
                }
                return time_within(bounds, a, b, false);
            }
            stage unused{};
            return time_of_impact_further(a, b, unused);
        }
        if (const auto f = started.finish(); f.certain) {
            observer(stage::filter);
            const encounter what = f.what();
            if (!is_collision(what)) { // also parting balls: on x87 they may become certain only now
                return std::nullopt;
            }
            if (what == encounter::overlap) {
                return time_of_overlap(a, b);
            }
            stage unused{};
            return time_of_impact_further(a, b, unused); // nearly a graze
        }
    }
    return tell_further<true>(a, b, observer);
}

} // namespace detail

// Laws 1 to 6 of classify_balls.hpp, and
//   9. a larger ball is met no later.

// The exact time at which two balls touch first; empty for recede and miss. Throws as classify does.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<impact_time<N, T>>
time_of_impact(const ball<N, T>& a, const ball<N, T>& b, Observer&& observer = {}) {
    return detail::time_of_two(a, b, observer);
}

// The exact time, not before both are on their way, at which two flights touch first; empty for recede and miss, t0 for
// an overlap. Throws as classify does. Laws 1 to 6, 12 and 13.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<impact_time<N, T>>
time_of_impact(const flight<N, T>& a, const flight<N, T>& b, Observer&& observer = {}) {
    return detail::time_of_two(a, b, observer);
}

} // namespace graze::inline v0_1
