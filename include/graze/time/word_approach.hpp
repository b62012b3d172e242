// When two movers meet, in double words with a proven error, however much cancels, except for ties.
//
// u = 2^-53, doubles to nearest. What sums and products lose comes from word_rounding; errors are upper bounds, with
// room for the roundings of their own expressions.
#pragma once

#include <graze/machine/accurate_sum.hpp>
#include <graze/machine/lanes.hpp>
#include <graze/predicate/refined_balls.hpp>
#include <graze/time/sharp_discriminant.hpp>
#include <graze/time/word_cross.hpp>

#include <cmath>

namespace graze::inline v0_1::detail {

// √d, d > 0, d with an error: root and 1/(2 root).high. With r = √dh in doubles, root = r + (d - r²)/(2r) is
// off by at most u²/2 root for the next term, 4.5u² for three roundings of what is at most 3u d, and 1.5u² each for
// 1/(2r) and the product: 2^-102 root covers them. And |√D - √d| <= |D - d|/√d.
template <bool Fused>
struct word_root {
    loose_word<Fused> value;
    double error;

    [[gnu::always_inline]] word_root(const loose_word<Fused>& d, double d_error) noexcept {
        const double root = settled(plain_sqrt(d.high));
        const double half_inverse = settled(0.5 / root);
        const auto square = two_square(as_factor<Fused>(root));
        const double rest = settled(settled(d.high - square.value) - square.error) + d.low;
        value = loose_word<Fused>(root, settled(rest * half_inverse));
        error = 2.25 * d_error * half_inverse + 0x1p-102 * root;
    }
};

// Σ|x_i| of the leading parts.
template <int N, class V>
[[nodiscard, gnu::always_inline]] inline double sum_of_sizes(const vec<N, V>& x) noexcept {
    double sum = std::fabs(x[0].high);
    for (int i = 1; i < N; ++i) {
        sum += std::fabs(x[i].high);
    }
    return sum;
}

// Two movers in words: the encounter if it is certain; for a hit also a, √D and the time from their start.
template <bool Fused, moving B>
struct word_approach {
    static constexpr int N = dimension_of<B>;
    using word = loose_word<Fused>;

    relative_motion<N, word, word, word> motion; // in order
    relative_motion<N, term_size, term_size, term_size> size;
    double off = 0; // the total error of Δx; 0 for balls
    word_cross<Fused, N> cross;
    word a, root, time;
    double root_error = 0, time_error = 0;
    double length2 = 0;
    bool in_range = false;
    bool good = false; // whether the errors of root and time are known
    bool nearly_grazes = false;
    int what = undecided;

    [[gnu::always_inline]] word_approach(const B& x, const B& y) noexcept {
        in_range = with_sizes_at_start<inputs_in_words<Fused>>(
            x, y, [this](const auto& m, const auto& s, bool epochs) __attribute__((always_inline)) {
                motion = m;
                size = s;
                return epochs;
            });
        if constexpr (is_flight<B>) {
            if (as_stored(x.since) != as_stored(y.since)) { // otherwise Δx is exact, as for balls
                constexpr double k = of_words::bound(analysed_movers<true>::value<N, of_words>().dx[0]);
                for (int i = 0; i < N; ++i) {
                    motion.dx[i] = as_input(motion.dx[i]);
                    off += k * size.dx[i].value;
                }
                off += 0x1p-900;
            }
        }
        cross = word_cross<Fused, N>(motion.dx, motion.du, 1.0001 * off * sum_of_sizes(motion.du));
        a = graze::squared_norm(motion.du);
        what = decide();
    }

    // For a hit: √D from more digits of D, if words keep fewer of it than the rounding of a velocity needs. The time
    // hardly needs them.
    [[gnu::always_inline]] void sharpen_root() noexcept {
        if (nearly_grazes) {
            const auto pair = [](const word& x) { return exact_pair<double>{x.high, x.low}; };
            const auto pairs = [&](const vec<N, word>& x) { return make_vec<N>([&](int i) { return pair(x[i]); }); };
            const motion_in_words<N> m{pairs(motion.dx), pairs(motion.du), pair(motion.R)};
            const sharp_number d = with_fused_products(sharp_discriminant<N>{&m}, sharp_number{});
            if (d.value.value > 0) {
                const word_root<Fused> found(word(d.value), d.error + lost_of_d);
                root = found.value;
                root_error = found.error;
                good = is_good();
            }
        }
    }

  private:
    double lost_of_d = 0;   // lost by underflow
    double denominator = 0; // -h + √D, and its error
    double denominator_error = 0;

    [[nodiscard, gnu::always_inline]] bool is_good() const noexcept {
        return (static_cast<unsigned>(16 * root_error < root.high) &
                static_cast<unsigned>(16 * denominator_error < denominator)) != 0;
    }
    [[nodiscard, gnu::always_inline]] int decide() noexcept {
        const sized_movers<of_words, B, word> sized(motion, size, in_range);
        in_range = sized.in_range();
        length2 = sized.length2;
        lost_of_d = sized.lost;
        if (!in_range) {
            return undecided;
        }
        auto h = sized(coefficient_h{});
        if (const int s = h.sign(); s >= 0) {
            return s == open ? undecided : static_cast<int>(encounter::recede);
        }
        h.value = as_input(h.value); // terms may have cancelled
        auto c = sized(coefficient_c{});
        c.value = as_input(c.value);
        if (std::fabs(c.value.high) < 0x1p-10 * length2) {
            c = near_c(sized.lost);
        }
        if (const int s = c.sign(); s != 1) {
            return s == open ? undecided : static_cast<int>(encounter::overlap);
        }
        const double cross_size = cross.size();
        const double terms = sized.size.R.value * sized.size.R.value * sized.speed2 + cross_size * cross_size;
        const double d_error =
            lagrange_bounds<of_words, analysed_movers<false>, N>::of_rest * terms + cross.moved + sized.lost;
        const word loose = discriminant_of_cross{}(motion.R, a, cross.value);
        const word d(two_sum(loose.high, loose.low));
        if (!(std::fabs(d.high) > 2 * d_error)) {
            return undecided;
        }
        if (d.high < 0) {
            return static_cast<int>(encounter::miss);
        }
        const word_root<Fused> found(d, d_error);
        root = found.value;
        root_error = found.error;
        nearly_grazes = off == 0 && d.high < 0x1p-38 * terms;
        find_time(h, c);
        return static_cast<int>(encounter::hit);
    }

    // c/(-h + √D). With t = c.high/d in doubles, right to 4u but for what low parts make, the residual c - t d is at
    // most 2^-49 c; it takes 4 roundings, the quotient by it 3 more, 1/d being right to 2u: less than 2^-98 of the
    // time.
    [[gnu::always_inline]] void find_time(const bounded_value<word>& h, const bounded_value<word>& c) noexcept {
        const word sum = root - h.value;
        const double inverse = settled(1 / sum.high);
        const double near = settled(c.value.high * inverse);
        const auto back = two_product(as_factor<Fused>(near), as_factor<Fused>(sum.high));
        const double residual =
            settled(settled(c.value.high - back.value) - back.error) + settled(c.value.low - near * sum.low);
        time = word(fast_two_sum(near, settled(residual * inverse)));
        denominator = sum.high;
        denominator_error = root_error + h.error + 0x1p-102 * sum.high;
        time_error = 1.25 * ((c.error + near * denominator_error) * inverse) + 0x1p-98 * near;
        good = is_good();
    }

    // c of movers that nearly touch.
    [[nodiscard, gnu::always_inline]] bounded_value<word> near_c(double lost) const noexcept {
        accurate_sum<Fused> sum;
        for (int i = 0; i < N; ++i) {
            sum.add_square({motion.dx[i].high, motion.dx[i].low}, 1);
        }
        sum.add_square({motion.R.high, motion.R.low}, -1);
        const word c(sum.rounded());
        const double moved = 1.0001 * off * (2 * sum_of_sizes(motion.dx) + off);
        return {c, 0x1p-104 * std::fabs(c.high) + 0x1p-142 * length2 + (moved + lost)};
    }
};

} // namespace graze::inline v0_1::detail
