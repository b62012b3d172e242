// The time of two movers that are too far away, too slow, of odd units or too near a graze for the filter: in doubles
// by the sizes of terms, in double words, and scaled first where that is needed.
#pragma once

#include <graze/time/enclosure.hpp>
#include <graze/time/mover_approach.hpp>
#include <graze/time/scaled_rounding.hpp>
#include <graze/time/word_approach.hpp>

#include <optional>

namespace graze::inline v0_1::detail {

// What becomes of two movers, `undecided` where all this leaves it open, by the stage given. Of a hit, in units of
// 2^unit: when, if good; else where its time is, if that is known, in units as they are.
struct further_time {
    int what = undecided;
    stage decided_by = stage::exact;
    bool good = false;
    bounded<double> time{};
    int unit = 0;
    enclosure bounds{};
};

template <int N>
struct approach_in_words {
    const flight<N, double>*a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] further_time operator()(std::bool_constant<Fused>) const noexcept {
        const word_approach<Fused, flight<N, double>> w(*a, *b);
        further_time r;
        r.what = w.what;
        r.decided_by = stage::double_word;
        r.good = w.good;
        r.time = on_clock_of(*a, *b, {w.time.high, w.time.low, (1 + 0x1p-40) * w.time_error});
        return r;
    }
};

// Of movers in range, in doubles.
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

// Of scaled movers of which the filter is certain.
template <moving B>
[[nodiscard, gnu::always_inline]] inline bool filter_time(further_time& r, const B& a, const B& b) noexcept {
    const auto filtered = start_filter(a, b).finish();
    if (!filtered.certain) {
        return false;
    }
    r.what = static_cast<int>(filtered.what());
    r.decided_by = stage::filter;
    if (filtered.what() == encounter::hit) {
        const double near = root_stable{}(filtered.c, filtered.h, plain_sqrt(filtered.discriminant));
        const auto found = with_best_products(time_by_doubles<B>{&a, &b, near});
        r.good = found.good;
        r.time = found.time;
        return found.good;
    }
    return true;
}

// What has been tried before: the filter alone, or a step from an enclosure's time as well; `time`: of movers that hit,
// of which only the time is asked.
enum class tried { filter, step, time };

// Of movers whose radii are not negative.
template <moving B>
[[nodiscard, gnu::noinline]] further_time find_further_time(const B& a, const B& b, tried before) noexcept {
    if constexpr (std::same_as<number_in<B>, float>) {
        return keeps_subnormals() ? find_further_time(in_doubles(a), in_doubles(b), before) : further_time{};
    } else {
        further_time r;
        const bool is_usual = has_usual_size(a, b) && refine_time(r, a, b);
        const bool is_hit = r.what == static_cast<int>(encounter::hit);
        if (before == tried::filter && is_usual && r.what != undecided && (!is_hit || r.bounds.is_known())) {
            return r;
        }
        r = {};
        if constexpr (has_error_free_doubles) {
            scaled_movers<B> s;
            const B* x = &a;
            const B* y = &b;
            if (!rounds_to_nearest()) {
                return r;
            }
            if (!is_usual) {
                s = scaled(a, b);
                if (!s.known) {
                    return r;
                }
                x = &s.a;
                y = &s.b;
            }
            const bool steps = before == tried::time || !is_usual;
            if (!steps || !filter_time(r, *x, *y)) {
                const auto& as_a = as_flight(*x);
                const auto& as_b = as_flight(*y);
                r = with_best_products(approach_in_words<dimension_of<B>>{&as_a, &as_b});
            }
            r.unit = s.length - s.velocity;
        }
        return r;
    }
}

// That time rounded; empty where a doubt is left.
template <class T>
[[nodiscard]] inline std::optional<T> round_further_time(const further_time& t, rounding mode) noexcept {
    if (!t.good) {
        return std::nullopt;
    }
    if (mode == rounding::nearest) {
        return rounded_quickly<T>(t.time, t.unit);
    }
    return t.unit == 0 && std::is_same_v<T, double> ? rounded_without_doubt<T>(t.time, mode)
                                                    : rounded_scaled<T>(t.time, t.unit, mode);
}

} // namespace graze::inline v0_1::detail
