// The time of two balls that are too far away, too slow, too large or too near a graze for doubles: in double words,
// scaled first where that is needed.
#pragma once

#include <graze/time/scaled_rounding.hpp>
#include <graze/time/word_approach.hpp>

#include <optional>

namespace graze::inline v0_1::detail {

// What becomes of two balls, `undecided` where words leave that open; of a hit, when, in units of 2^unit, if good.
struct further_time {
    int what = undecided;
    bool good = false;
    bounded<double> time{};
    int unit = 0;
    bool in_range = false;
};

template <int N>
struct approach_in_words {
    const ball<N, double>*a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] further_time operator()(std::bool_constant<Fused>) const noexcept {
        const word_approach<Fused, N> w(*a, *b);
        return {w.what, w.good, {w.time.high, w.time.low, (1 + 0x1p-40) * w.time_error}, 0, w.in_range};
    }
};

// Of balls whose radii are not negative.
template <int N>
[[nodiscard, gnu::noinline]] further_time find_further_time(const ball<N, double>& a,
                                                            const ball<N, double>& b) noexcept {
    further_time r;
    if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest()) {
            const ball<N, double>* x = &a;
            const ball<N, double>* y = &b;
            scaled_balls<N> s;
            for (bool usual = has_usual_size(a, b);; usual = false) {
                if (!usual) {
                    s = scaled(a, b);
                    if (!s.known) {
                        break;
                    }
                    x = &s.a;
                    y = &s.b;
                }
                r = with_best_products(approach_in_words<N>{x, y});
                if (r.in_range || !usual) {
                    break;
                }
            }
            r.unit = s.length - s.velocity;
        }
    }
    return r;
}
template <int N>
[[nodiscard]] further_time find_further_time(const ball<N, float>& a, const ball<N, float>& b) noexcept {
    return keeps_subnormals() ? find_further_time(in_doubles(a), in_doubles(b)) : further_time{};
}

// That time rounded; empty where a doubt is left.
template <class T>
[[nodiscard]] inline std::optional<T> round_further_time(const further_time& t, rounding mode) noexcept {
    return !t.good                                    ? std::nullopt
           : t.unit == 0 && std::is_same_v<T, double> ? rounded_without_doubt<T>(t.time, mode)
                                                      : rounded_scaled<T>(t.time, t.unit, mode);
}

} // namespace graze::inline v0_1::detail
