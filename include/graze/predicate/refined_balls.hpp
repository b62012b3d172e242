// Two balls of which the filter is not certain: scaled, in Lagrange's form, in double words.
#pragma once

#include <graze/machine/fused.hpp>
#include <graze/pair/bounded_motion.hpp>
#include <graze/pair/rounded_motion.hpp>
#include <graze/pair/scaled_balls.hpp>
#include <graze/pair/stage.hpp>
#include <graze/predicate/filtered_balls.hpp>

namespace graze::inline v0_1::detail {

// Which encounter it is, as a number, or `undecided`; and the stage that was needed.
struct refined_encounter {
    int what = undecided;
    stage decided_by = stage::exact;
};

// The motion of two balls as the analysis sees it: all of its numbers are inputs.
struct analysed_balls {
    template <int N, class Arithmetic>
    [[nodiscard]] static consteval auto value() {
        const auto each = make_vec<N>([](int) { return Arithmetic::input; });
        return relative_motion{each, each, Arithmetic::input};
    }
};

template <bool Fused, int N>
[[nodiscard, gnu::always_inline]] inline auto word_motion(const ball<N, double>& a, const ball<N, double>& b) noexcept {
    using word = loose_word<Fused>;
    const auto difference = [](const vec<N, double>& x, const vec<N, double>& y) __attribute__((always_inline)) {
        return make_vec<N>([&](int i) { return word(two_difference(x[i], y[i])); });
    };
    return relative_motion{difference(a.position, b.position), difference(a.velocity, b.velocity),
                           word(two_sum(a.radius, b.radius))};
}

template <int N>
struct encounter_in_words {
    const ball<N, double>*a, *b;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] int operator()(std::bool_constant<Fused>) const noexcept {
        const auto m = word_motion<Fused>(*a, *b);
        return decided_encounter(sized_motion<of_words, analysed_balls, N, loose_word<Fused>>(m, size_of(m)));
    }
};
template <int N>
[[nodiscard, gnu::noinline]] refined_encounter refine_in_words(const ball<N, double>& a,
                                                               const ball<N, double>& b) noexcept {
    if constexpr (has_error_free_doubles) {
        if (rounds_to_nearest()) {
            return {with_best_products(encounter_in_words<N>{&a, &b}), stage::double_word};
        }
    }
    return {};
}

// Of a motion whose numbers are in range.
template <int N>
[[nodiscard, gnu::always_inline]] inline refined_encounter
refine_sized(const sized_motion<of_doubles, analysed_balls, N, double>& sized, const ball<N, double>& a,
             const ball<N, double>& b) noexcept {
    const int what = decided_encounter(sized);
    return what != undecided ? refined_encounter{what, stage::refined} : refine_in_words(a, b);
}

template <int N>
[[nodiscard, gnu::noinline]] refined_encounter refine_scaled(const ball<N, double>& a,
                                                             const ball<N, double>& b) noexcept {
    const scaled_balls<N> s = scaled(a, b);
    if (!s.known) {
        return {};
    }
    const auto m = rounded_motion(s.a, s.b);
    const sized_motion<of_doubles, analysed_balls, N, double> sized(m, size_of(m));
    if (!sized.in_range()) {
        return {};
    }
    const started_filter<double, ball_filter<N, double>> started(m, sized.length2);
    if (const auto filtered = started.finish(); filtered.certain) {
        return {static_cast<int>(filtered.what()), stage::filter};
    }
    return refine_sized<N>(sized, s.a, s.b);
}

// Of balls whose radii are not negative.
template <int N>
[[nodiscard, gnu::always_inline]] inline refined_encounter refine(const ball<N, double>& a,
                                                                  const ball<N, double>& b) noexcept {
    if (has_usual_size(a, b)) {
        const auto m = rounded_motion(a, b);
        const sized_motion<of_doubles, analysed_balls, N, double> sized(m, size_of(m));
        if (sized.in_range()) {
            return refine_sized<N>(sized, a, b);
        }
    }
    return refine_scaled(a, b);
}
template <int N>
[[nodiscard]] constexpr const ball<N, double>& in_doubles(const ball<N, double>& b) noexcept {
    return b;
}
template <int N>
[[nodiscard, gnu::always_inline]] inline ball<N, double> in_doubles(const ball<N, float>& b) noexcept {
    return {rounded(wide(b.position)), rounded(wide(b.velocity)), static_cast<double>(as_stored(b.radius))};
}
template <int N>
[[nodiscard, gnu::always_inline]] inline refined_encounter refine(const ball<N, float>& a,
                                                                  const ball<N, float>& b) noexcept {
    return keeps_subnormals() ? refine(in_doubles(a), in_doubles(b)) : refined_encounter{};
}

} // namespace graze::inline v0_1::detail
