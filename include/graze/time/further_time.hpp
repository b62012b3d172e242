// The time of two movers that are too far away, too slow, too near a graze or in units too unusual for the filter:
// scaled first if need be, then in doubles by the sizes of terms, then in double words.
#pragma once

#include <graze/time/close_approach.hpp>
#include <graze/time/enclosure.hpp>
#include <graze/time/mover_approach.hpp>
#include <graze/time/scaled_rounding.hpp>
#include <graze/time/word_approach.hpp>

namespace graze::inline v0_1::detail {

// The encounter of two movers, `undecided` if still open, and the stage that decided it. For a hit also its time in
// units of 2^unit, if good; otherwise an enclosure of its time in the given units, if one is known.
struct further_time : approached_time {
    int what = undecided;
    stage decided_by = stage::exact;
    enclosure bounds{};
    bool in_range = true; // whether double words have the range
};

template <int N>
struct approach_in_words {
    const flight<N, double>*a, *b;
    further_time* kept;

    template <bool Fused>
    [[gnu::always_inline]] void operator()(std::bool_constant<Fused>) const noexcept {
        const word_approach<Fused, flight<N, double>> w(*a, *b);
        kept->what = w.what;
        kept->decided_by = stage::double_word;
        kept->good = w.good;
        kept->in_range = w.in_range;
        kept->time = on_clock_of(*a, *b, {w.time.high, w.time.low, (1 + 0x1p-40) * w.time_error});
    }
};

// In doubles, for movers in range.
template <moving B>
[[nodiscard, gnu::always_inline]] inline bool refine_time(further_time& r, const B& a, const B& b) noexcept {
    return with_sizes_at_start<inputs_in_doubles>(
        a, b, [&](const auto&... m) __attribute__((always_inline)) {
            const sized_movers<of_doubles, B, double> sized(m...);
            if (!sized.in_range()) {
                return false;
            }
            const auto found = encounter_of_sized(sized);
            r.what = found.what;
            r.decided_by = stage::refined;
            if (found.what == static_cast<int>(encounter::hit)) {
                r.bounds = enclose_closely(found.c.value, found.h.value, found.discriminant.value, found.c.error,
                                           found.h.error, found.discriminant.error);
                if constexpr (is_flight<B>) {
                    r.bounds = counted_from<number_in<B>>(as_stored(a.since < b.since ? b.since : a.since), r.bounds);
                }
            }
            return true;
        });
}

// For movers that come from far away, and for balls that nearly touch; others are left open. Either sees to its range;
// those whose lengths are out of it are many where exponents are far apart.
template <moving B>
[[nodiscard, gnu::always_inline]] inline decided_approach approach_by_place(const B& a, const B& b) noexcept {
    decided_approach r;
    if constexpr (has_error_free_doubles) {
        with_motion_at_start(
            a, b, [&](const auto& m, double length2, bool in_range) __attribute__((always_inline)) {
                if (!hold_together(in_range, within_powers<-200, 200>(length2))) {
                    return;
                }
                if (is_distant(m.R, length2)) {
                    r = with_fused_products(distant_movers<B>{&a, &b}, r);
                } else if constexpr (!is_flight<B>) {
                    if (std::fabs(coefficient_c{}(m)) < 0x1p-30 * length2) {
                        r = with_fused_products(close_balls<dimension_of<B>>{&a, &b}, r);
                    }
                }
            });
        if (!adds_to_nearest()) {
            r.what = undecided;
        }
    }
    return r;
}

// For movers in range what the filter is certain of; for a hit also the time, by one step. False if that is not close
// enough.
template <moving B>
[[nodiscard, gnu::noinline]] bool filter_time(further_time& r, const B& a, const B& b) noexcept {
    const auto filtered = start_filter(a, b).finish();
    if (!filtered.certain) {
        return false;
    }
    r.what = static_cast<int>(filtered.what());
    r.decided_by = stage::filter;
    if (filtered.what() != encounter::hit) {
        return true;
    }
    const double near = root_stable{}(filtered.c, filtered.h, plain_sqrt(filtered.discriminant));
    with_best_products(time_by_doubles<B, further_time>{&a, &b, near, &r});
    return r.good;
}
template <moving B>
[[gnu::always_inline]] inline void words_time(further_time& r, const B& a, const B& b) noexcept {
    const auto& x = as_flight(a);
    const auto& y = as_flight(b);
    with_best_products(approach_in_words<dimension_of<B>>{&x, &y, &r});
}

// The encounter of two balls as a number, or `undecided`; for a hit also its time, rounded to nearest.
struct rounded_approach {
    double time = 0;
    int what = undecided;
};
// For balls in unusual units: by the filter and one step, scaled. To nearest; where subnormals become zeros, the loss
// is that of a safe scaling.
template <int N>
struct scaled_approach {
    const ball<N, double>*a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] rounded_approach operator()(std::bool_constant<Fused> fused) const noexcept {
        const scaled_motion s(computed_motion(*a, *b), larger_radius(*a, *b));
        const auto filtered = filter_motion(s.motion);
        if (!all_hold(filtered.certain, s.safe, adds_to_nearest())) {
            return {};
        }
        if (filtered.what() != encounter::hit) {
            return {0, static_cast<int>(filtered.what())};
        }
        const double near = root_stable{}(filtered.c, filtered.h, plain_sqrt(filtered.discriminant));
        const auto found = time_of_scaled<N>{a, b, s.by_length, s.by_velocity, near}(fused);
        const auto rounded = rounded_quickly<double>(found.time, s.unit());
        if (!(found.good && rounded && is_finite_input(*rounded))) {
            return {};
        }
        return {*rounded, static_cast<int>(encounter::hit)};
    }
};

// What has been tried before: the filter alone, or a step from an enclosure's time as well. `time`: the movers hit, and
// only the time is asked for.
enum class tried { filter, step, time };

// By steps and words, scaled if necessary; needs rounding to nearest.
template <moving B>
[[gnu::always_inline]] inline void time_by_words(further_time& r, const B& a, const B& b, bool is_usual,
                                                 tried before) noexcept {
    if (is_usual) {
        if constexpr (is_flight<B>) {
            if (before == tried::time && filter_time(r, a, b)) {
                return;
            }
        }
        words_time(r, a, b);
        if (r.in_range) {
            return;
        }
    }
    const scaled_movers<B> s = scaled(a, b);
    if (!s.known) {
        r.what = undecided;
        return;
    }
    r.unit = s.length - s.velocity;
    if (!filter_time(r, as_flight(s.a), as_flight(s.b))) {
        words_time(r, s.a, s.b);
    }
}

// For movers whose radii are not negative.
template <moving B>
[[nodiscard, gnu::noinline]] further_time find_further_time(const B& a, const B& b, tried before) noexcept {
    further_time r;
    if constexpr (std::same_as<number_in<B>, float>) {
        if (keeps_subnormals()) {
            return find_further_time(in_doubles(a), in_doubles(b), before);
        }
    } else {
        const bool is_usual = has_usual_size(a, b);
        if (before == tried::filter && is_usual) {
            if (refine_time(r, a, b) && r.what != undecided &&
                (r.what != static_cast<int>(encounter::hit) || r.bounds.is_known())) {
                return r;
            }
            r = further_time{};
        }
        if constexpr (has_error_free_doubles) {
            if (rounds_to_nearest()) {
                time_by_words(r, a, b, is_usual, before);
            } else {
                r.what = undecided;
            }
        }
    }
    return r;
}

} // namespace graze::inline v0_1::detail
