// Two movers that the filter leaves open: scaled, in Lagrange's form, in double words.
#pragma once

#include <graze/machine/fused.hpp>
#include <graze/pair/scaled_movers.hpp>
#include <graze/pair/sized_motion.hpp>
#include <graze/pair/stage.hpp>
#include <graze/predicate/filtered_balls.hpp>

namespace graze::inline v0_1::detail {

// The encounter as a number, or `undecided`, and the stage that was needed.
struct refined_encounter {
    int what = undecided;
    stage decided_by = stage::exact;
};

inline constexpr int out_of_range = -2;

// The motion of two movers as the analysis sees it: its inputs are differences and sums of the pair's numbers.
template <bool HasEpoch>
struct analysed_movers {
    template <int N, class Arithmetic>
    [[nodiscard]] static consteval auto value() {
        const auto each = make_vec<N>([](int) { return Arithmetic::input; });
        const relative_motion m{each, each, Arithmetic::input};
        if constexpr (HasEpoch) {
            return with_lead(m, make_vec<N>([](int) { return Arithmetic::given; }), Arithmetic::input);
        } else {
            return m;
        }
    }
};

// How differences and sums of the inputs are taken: rounded, or exactly.
struct inputs_in_doubles {
    [[nodiscard]] static double given(double x) noexcept { return x; }
    [[nodiscard]] static double difference(double x, double y) noexcept { return x - y; }
    [[nodiscard]] static double sum(double x, double y) noexcept { return x + y; }
};
template <bool Fused>
struct inputs_in_words {
    using word = loose_word<Fused>;
    [[nodiscard]] static word given(double x) noexcept { return {x, 0}; }
    [[nodiscard]] static word difference(double x, double y) noexcept { return word(two_difference(x, y)); }
    [[nodiscard]] static word sum(double x, double y) noexcept { return word(two_sum(x, y)); }
};

// use(motion, sizes, in_range) for two movers at the later epoch. sizes: of the terms that the motion's numbers were
// added up from. in_range: whether epochs are in range.
template <class In, moving B, class F>
[[nodiscard, gnu::always_inline]] inline auto with_sizes_at_start(const B& a, const B& b, F use) noexcept {
    constexpr int N = dimension_of<B>;
    const auto difference = [](const vec<N, double>& x, const vec<N, double>& y) __attribute__((always_inline)) {
        return make_vec<N>([&](int i) { return In::difference(as_stored(x[i]), as_stored(y[i])); });
    };
    const auto& x = state_of(a);
    const auto& y = state_of(b);
    relative_motion m{difference(x.position, y.position), difference(x.velocity, y.velocity),
                      In::sum(as_stored(x.radius), as_stored(y.radius))};
    auto size = size_of(m);
    bool in_range = true;
    if constexpr (is_flight<B>) {
        // A mode may read or write a lead as 0: it is out of range then.
        if (bits_of(a.since) != bits_of(b.since) && !(is_zero(a.since) && is_zero(b.since))) {
            const auto lead = In::difference(as_stored(b.since), as_stored(a.since));
            const double leading = leading_double(lead);
            const auto& u = leading > 0 ? x.velocity : y.velocity;
            const auto moving_at = make_vec<N>([&](int i) { return In::given(as_stored(u[i])); });
            m = with_lead(m, moving_at, lead);
            size = with_lead(size, size_of(moving_at), size_of(lead));
            in_range = within_powers<-900, 100>(std::fabs(leading));
        }
    }
    return use(m, size, in_range);
}

// For floats, whose subnormals are not read as zeros.
template <int N>
[[nodiscard]] constexpr const ball<N, double>& in_doubles(const ball<N, double>& b) noexcept {
    return b;
}
template <int N>
[[nodiscard, gnu::always_inline]] inline ball<N, double> in_doubles(const ball<N, float>& b) noexcept {
    return {rounded(wide(b.position)), rounded(wide(b.velocity)), static_cast<double>(as_stored(b.radius))};
}
template <int N>
[[nodiscard]] constexpr const flight<N, double>& in_doubles(const flight<N, double>& f) noexcept {
    return f;
}
template <int N>
[[nodiscard, gnu::always_inline]] inline flight<N, double> in_doubles(const flight<N, float>& f) noexcept {
    return {in_doubles(f.state), static_cast<double>(as_stored(f.since))};
}

// The encounter in doubles by the sizes of terms, and in double words.
template <class Arithmetic, moving B, class V>
using sized_movers = sized_motion<Arithmetic, analysed_movers<is_flight<B>>, dimension_of<B>, V>;

template <moving B>
struct encounter_in_words {
    const B *a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] limited_encounter operator()(std::bool_constant<Fused>) const noexcept {
        return with_sizes_at_start<inputs_in_words<Fused>>(
            *a, *b, [](const auto&... m) __attribute__((always_inline)) {
                return limited(encounter_of_sized(sized_movers<of_words, B, loose_word<Fused>>(m...)));
            });
    }
};
// Where it is undecided, `left` becomes what is left open.
template <moving B>
[[nodiscard, gnu::noinline]] refined_encounter refine_in_words(const B& a, const B& b, open_number& left) noexcept {
    if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest()) {
            const limited_encounter r = with_best_products(encounter_in_words<B>{&a, &b});
            if (r.what == undecided) {
                left = {r.left, r.limit};
            }
            return {r.what, stage::double_word};
        }
    }
    return {};
}

// The sign of c alone or, where words leave it open, a limit of it. Velocities don't matter, as long as they are
// finite.
struct refined_distance {
    int sign = open;
    double limit = 0;
};
template <moving B>
struct distance_in_words {
    const B *a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] refined_distance operator()(std::bool_constant<Fused>) const noexcept {
        return with_sizes_at_start<inputs_in_words<Fused>>(
            *a, *b, [](const auto& m, const auto& size, bool in_range) __attribute__((always_inline)) {
                const sized_movers<of_words, B, loose_word<Fused>> sized(m, size, in_range);
                if (!within_powers<-300, 262>(sized.length2) || !in_range) {
                    return refined_distance{};
                }
                const auto c = sized(coefficient_c{});
                return refined_distance{c.sign(), limit_of(c)};
            });
    }
};
template <moving B>
[[nodiscard, gnu::noinline]] int distance_further(const B& a, const B& b, open_number& left) noexcept {
    if constexpr (std::same_as<number_in<B>, float>) {
        return keeps_subnormals() ? distance_further(in_doubles(a), in_doubles(b), left) : open;
    } else if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest()) {
            const refined_distance r = with_best_products(distance_in_words<B>{&a, &b});
            left = {open_number::c, r.limit};
            if (r.limit != 0) {
                return r.sign;
            }
            if (const scaled_movers<B> s = scaled(a, b); s.known) {
                const refined_distance far = with_best_products(distance_in_words<B>{&s.a, &s.b});
                left = {open_number::c, far.limit, s.length, s.velocity};
                return far.sign;
            }
        }
    }
    return open;
}

// In doubles, and in words where these leave it open. False for movers out of range.
template <moving B>
[[nodiscard, gnu::always_inline]] inline bool refine_in_range(refined_encounter& r, const B& a, const B& b,
                                                              open_number& left) noexcept {
    const int what = with_sizes_at_start<inputs_in_doubles>(
        a, b, [](const auto&... m) __attribute__((always_inline)) {
            const sized_movers<of_doubles, B, double> sized(m...);
            return sized.in_range() ? decided_encounter(sized) : out_of_range;
        });
    r = what == undecided ? refine_in_words(a, b, left) : refined_encounter{what, stage::refined};
    return what != out_of_range;
}

// For movers out of range: scaled, by the filter, in doubles and in words.
template <moving B>
[[nodiscard, gnu::noinline]] refined_encounter refine_scaled(const B& a, const B& b, open_number& left) noexcept {
    const scaled_movers<B> s = scaled(a, b);
    if (!s.known) {
        return {};
    }
    const auto started = start_filter(s.a, s.b);
    // What a mode takes is small beside the largest numbers. Their differences may be small as well.
    const bool safe = (s.safe && std::min(started.q.a, started.length2) > 0x1p-40) || keeps_subnormals();
    if (const auto filtered = started.finish(); all_hold(filtered.certain, safe)) [[likely]] {
        return {static_cast<int>(filtered.what()), stage::filter};
    }
    refined_encounter r;
    if (!keeps_subnormals() || !refine_in_range(r, s.a, s.b, left)) {
        return {};
    }
    left.length = s.length;
    left.velocity = s.velocity;
    return r;
}

// For movers whose radii are not negative.
template <moving B>
requires std::same_as < number_in<B>,
double > [[nodiscard, gnu::always_inline]] inline refined_encounter refine(const B& a, const B& b,
                                                                           open_number& left) noexcept {
    refined_encounter r;
    if (has_usual_size(a, b) && refine_in_range(r, a, b, left)) {
        return r;
    }
    return refine_scaled(a, b, left);
}
template <moving B>
requires std::same_as < number_in<B>,
float > [[nodiscard, gnu::always_inline]] inline refined_encounter refine(const B& a, const B& b,
                                                                          open_number& left) noexcept {
    return keeps_subnormals() ? refine(in_doubles(a), in_doubles(b), left) : refined_encounter{};
}

} // namespace graze::inline v0_1::detail
