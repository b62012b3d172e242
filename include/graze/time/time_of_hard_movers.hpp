// When two movers meet that the filter leaves open, or that it knows to hit but not closely enough when: by further
// stages, and at last by integers.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/time/further_time.hpp>
#include <graze/time/impact_time.hpp>

#include <optional>
#include <type_traits>

namespace graze::inline v0_1::detail {

// x exactly: where a mode reads subnormals as zeros, a conversion would do so, too.
template <class T>
[[nodiscard]] constexpr double instant_in_double(const T& x) noexcept {
    if constexpr (std::is_same_v<T, float>) {
        const binary b = split(x);
        return static_cast<double>(b.significand) * power_of_two(b.exponent);
    } else {
        return static_cast<double>(x);
    }
}

// An event's time, with the enclosure from its exact quadratic.
template <int N, class T>
[[nodiscard, gnu::noinline]] constexpr impact_time<N, T> enclosed_exactly(event<N, T> e) {
    constexpr impact_time_key key{};
    if (std::is_constant_evaluated()) {
        return impact_time<N, T>(key, e.overlap && !e.timed ? enclosure{0, 0} : enclosure{}, e);
    }
    const double start = instant_in_double(e.start());
    if (!e.overlap) {
        timed_workspace room;
        const exact_root exact = e.procedures->root(e, room);
        const enclosure bounds = enclose(exact.from_start, exact.unit);
        e.overlap = bounds.is_point(); // they touch
        if (!e.overlap) {
            return impact_time<N, T>(key, e.timed ? counted_from<T>(start, bounds) : bounds, e);
        }
    }
    return impact_time<N, T>(key, enclosure{start, 0}, e);
}

template <moving B>
using time_of_movers = impact_time<dimension_of<B>, number_in<B>>;
template <moving B>
using event_of_movers = event<dimension_of<B>, number_in<B>>;

// The time of two movers, constructed where it is returned. nearest: as in an event.
template <moving B>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<time_of_movers<B>>
time_within(const enclosure& bounds, const B& a, const B& b, bool overlap, bool nearest = false) {
    return std::optional<time_of_movers<B>>(std::in_place, impact_time_key{}, bounds, two_balls<dimension_of<B>>{}, a,
                                            b, event_kind::balls, 0, overlap, nearest);
}

// For two movers that overlap: their start.
template <moving B>
[[nodiscard, gnu::noinline]] constexpr std::optional<time_of_movers<B>> time_of_overlap(const B& a, const B& b) {
    const double start = instant_in_double(start_of(epochs_of(a, b)));
    return time_within(enclosure{start, 0}, a, b, true);
}

// The time of two movers whose velocities differ, by integers.
template <moving B>
[[nodiscard, gnu::noinline]] constexpr std::optional<time_of_movers<B>> time_of_impact_exactly(const B& a, const B& b) {
    const encounter what = classify_exactly(a, b, open_number{});
    if (!is_collision(what)) {
        return std::nullopt;
    }
    return enclosed_exactly(
        event_of_movers<B>(two_balls<dimension_of<B>>{}, a, b, event_kind::balls, 0, what == encounter::overlap));
}

// An enclosure around a time that is rounded to `nearest`, unknown beyond 2^±900. error: of an unrounded time. Without
// a branch, which could be taken only when all else is known.
[[nodiscard]] inline enclosure enclosure_around(double nearest, double error = 0) noexcept {
    const double near = absolute(nearest);
    const std::uint64_t known = opaque(std::uint64_t{within_powers<-900, 900>(near)});
    const std::uint64_t bits = bits_of(0x1p-49 * near + error);
    const std::uint64_t unknown = bits_of(enclosure::unknown);
    return {nearest, std::bit_cast<double>(unknown ^ ((bits ^ unknown) & (0 - known)))};
}

// The time of two movers of which this is known, with the number that it is rounded to where that is certain.
template <moving B>
[[nodiscard, gnu::always_inline]] inline std::optional<time_of_movers<B>> time_by_place(const decided_approach& found,
                                                                                        const B& a, const B& b) {
    if (found.is_hit()) {
        const bounded<double> time = on_clock_of(a, b, found.time());
        const double near = settled(time.high + settled(time.low));
        const enclosure bounds{near, 0x1p-49 * absolute(near) + time.error};
        return time_within(bounds, a, b, false, agree<double>(ends_of<double>(time)));
    }
    return found.what == static_cast<int>(encounter::overlap) ? time_of_overlap(a, b) : std::nullopt;
}

// The time of two movers that the filter leaves open, or that it knows to hit but not closely enough when: by all
// further stages. `by` becomes the one that was needed.
template <moving B>
[[nodiscard, gnu::noinline]] constexpr std::optional<time_of_movers<B>> time_of_impact_further(const B& a, const B& b,
                                                                                               stage& by) {
    using T = number_in<B>;
    if (rest_together(a, b)) {
        by = stage::filter;
        return std::nullopt;
    }
    if constexpr (std::is_floating_point_v<T>) {
        if (!std::is_constant_evaluated() && plain_radii(state_of(a).radius, state_of(b).radius)) {
            if constexpr (std::is_same_v<T, double>) {
                if (has_usual_size(a, b)) {
                    if (const auto found = approach_by_place(a, b); found.what != undecided) {
                        by = stage::double_word;
                        return time_by_place(found, a, b);
                    }
                }
            }
            const further_time t = find_further_time(a, b, tried::filter);
            by = t.decided_by;
            if (t.what == static_cast<int>(encounter::recede) || t.what == static_cast<int>(encounter::miss)) {
                return std::nullopt;
            }
            if (t.what == static_cast<int>(encounter::overlap)) {
                return time_of_overlap(a, b);
            }
            if (t.what == static_cast<int>(encounter::hit)) {
                enclosure bounds = t.bounds;
                bool nearest = false;
                if (!bounds.is_known()) {
                    const auto rounded = round_approached<double>(t, rounding::nearest);
                    if (rounded && is_finite_input(*rounded)) {
                        bounds = enclosure_around(*rounded, t.unit == 0 ? t.time.error : 0);
                        nearest = std::is_same_v<T, double>;
                    }
                }
                if (bounds.is_known() || nearest) {
                    return time_within(bounds, a, b, false, nearest);
                }
            }
        }
    }
    by = stage::exact;
    return time_of_impact_exactly(a, b);
}

// For movers in unusual units: balls are scaled first, and where they are, their time is made.
template <moving B>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<time_of_movers<B>>
time_in_unusual_units(const B& a, const B& b, stage& by) {
    return time_of_impact_further(a, b, by);
}
template <int N>
struct time_of_scaled_balls {
    const ball<N, double>*a, *b;
    stage* by;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] std::optional<impact_time<N, double>>
    operator()(std::bool_constant<Fused> fused) const {
        const rounded_approach found = scaled_approach<N>{a, b}(fused);
        if (found.what == undecided) {
            return time_of_impact_further(*a, *b, *by);
        }
        *by = stage::filter;
        if (found.what == static_cast<int>(encounter::hit)) {
            return time_within(enclosure_around(found.time), *a, *b, false, true);
        }
        return found.what == static_cast<int>(encounter::overlap) ? time_of_overlap(*a, *b) : std::nullopt;
    }
};
template <int N>
[[nodiscard, gnu::noinline]] inline std::optional<impact_time<N, double>>
time_in_unusual_units(const ball<N, double>& a, const ball<N, double>& b, stage& by) {
    if (rest_together(a, b)) {
        by = stage::filter;
        return std::nullopt;
    }
    if constexpr (has_error_free_doubles) {
        return with_fused_products_or(time_of_scaled_balls<N>{&a, &b, &by},
                                      [&] { return time_of_impact_further(a, b, by); });
    } else {
        return time_of_impact_further(a, b, by);
    }
}

// One of these, which also tells the observer; the time is made where it is returned.
template <bool IsUsual, moving B, class Observer>
[[nodiscard, gnu::always_inline]] constexpr inline std::optional<time_of_movers<B>> tell_further(const B& a, const B& b,
                                                                                                 Observer&& observer) {
    stage by{};
    auto further = IsUsual ? time_of_impact_further(a, b, by) : time_in_unusual_units(a, b, by);
    observer(by);
    return further;
}

} // namespace graze::inline v0_1::detail
