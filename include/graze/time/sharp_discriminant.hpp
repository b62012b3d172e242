// D where it cancels so much that double words keep too little of it: for the root of two movers that nearly graze.
#pragma once

#include <graze/formula/relative_motion.hpp>
#include <graze/machine/accurate_sum.hpp>

#include <cmath>
#include <type_traits>

namespace graze::inline v0_1::detail {

// A number in two doubles, and a bound on its error; not known where it is 0.
struct sharp_number {
    exact_pair<double> value{0, 0};
    double error = 0;
};

// Doubles to be added up.
struct term_list {
    double term[32];
    int count = 0;

    [[gnu::always_inline]] constexpr void append(double x) noexcept { term[count++] = x; }
    [[gnu::always_inline]] constexpr void append(const exact_pair<double>& x) noexcept {
        append(x.value);
        append(x.error);
    }
    // The sum as three doubles, each small relative to the terms that are added up to the one before.
    [[nodiscard, gnu::noinline]] constexpr vec<3, double> sum() const noexcept {
        accurate_sum<false> all;
        for (int i = 0; i < count; ++i) {
            all.add(term[i]);
        }
        const auto first = two_sum(all.high, all.middle);
        const auto rest = two_sum(first.error, all.low);
        return {{first.value, rest.value, rest.error}};
    }
};

// A motion in double words, all of whose numbers are exact.
template <int N>
struct motion_in_words {
    vec<N, exact_pair<double>> dx, du;
    exact_pair<double> R;
};

// R² |Δu|² - |Δx × Δu|²: the discriminant of Lagrange's form. u = 2^-53.
//
// A component x of Δx × Δu adds up 14 terms. Two are rounded products of low parts: with S = |Δx_j Δu_k| +
// |Δx_k Δu_j| it is off by 14³u³ S + 2u³ S < 2^-147.5 S. R² and |Δu|², of at most 15 terms, are off by 2^-147.2 of
// themselves. As three doubles a sum of n terms has |middle| <= u |high| + n²u² S and |low| <= u |middle|. So a product
// of two leaves out and rounds less than 8u³ of itself, and of x² less than 8u³ x² + 1600 u⁴ |x| S + 2^17 u⁵ S². D adds
// up at most 28 terms: 2^-144.5 (R² |Δu|² + Σx²).
template <int N>
struct sharp_discriminant {
    const motion_in_words<N>* motion;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] sharp_number operator()(std::bool_constant<Fused>) const noexcept {
        const auto& [dx, du, R] = *motion;
        term_list of_radius, of_speed, of_d;
        add_square<Fused>(of_radius, R);
        for (int i = 0; i < N; ++i) {
            add_square<Fused>(of_speed, du[i]);
        }
        const auto radius2 = of_radius.sum();
        const auto speed2 = of_speed.sum();
        add_triples<Fused>(of_d, radius2, speed2, 1);
        double terms = radius2[0] * speed2[0];
        double error = 0;
        for (int i = N == 3 ? 0 : 2; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            term_list of_x;
            add_words<Fused>(of_x, dx[j], du[k], 1);
            add_words<Fused>(of_x, dx[k], du[j], -1);
            const auto x = of_x.sum();
            add_triples<Fused>(of_d, x, x, -1);
            const double size = std::fabs(x[0]);
            const double added = std::fabs(dx[j].value * du[k].value) + std::fabs(dx[k].value * du[j].value);
            terms += size * size;
            error += added * (0x1p-146 * size + 0x1p-240 * added);
        }
        const auto d = of_d.sum();
        const auto value = two_sum(d[0], settled(d[1] + d[2])); // of what cancelled, d[1] may be more than a last place
        return {value, 0x1p-104 * std::fabs(value.value) + (0x1p-143 * terms + error)};
    }

  private:
    template <bool Fused>
    [[gnu::always_inline]] static void add_square(term_list& to, const exact_pair<double>& x) noexcept {
        const auto value = as_factor<Fused>(x.value);
        to.append(two_square(value));
        to.append(two_product(value, as_factor<Fused>(2 * x.error)));
        to.append(settled(x.error * x.error));
    }
    // sign x y.
    template <bool Fused>
    [[gnu::always_inline]] static void add_words(term_list& to, const exact_pair<double>& x,
                                                 const exact_pair<double>& y, double sign) noexcept {
        const auto high = as_factor<Fused>(sign * x.value);
        const auto low = as_factor<Fused>(sign * x.error);
        const auto y_high = as_factor<Fused>(y.value);
        to.append(two_product(high, y_high));
        to.append(two_product(high, as_factor<Fused>(y.error)));
        to.append(two_product(low, y_high));
        to.append(settled(low.value * y.error));
    }
    template <bool Fused>
    [[gnu::always_inline]] static void add_triples(term_list& to, const vec<3, double>& x, const vec<3, double>& y,
                                                   double sign) noexcept {
        const auto high = as_factor<Fused>(sign * x[0]);
        const auto middle = as_factor<Fused>(sign * x[1]);
        const auto y_high = as_factor<Fused>(y[0]);
        to.append(two_product(high, y_high));
        to.append(two_product(high, as_factor<Fused>(y[1])));
        to.append(two_product(middle, y_high));
        to.append(settled(middle.value * y[1] + (high.value * y[2] + sign * x[2] * y[0])));
    }
};

} // namespace graze::inline v0_1::detail
