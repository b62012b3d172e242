// The bounds of quotients and roots, in two steps. First, graze::error_bound bounds the sums and products that they
// use: c, h and D, or a plane's height and speed. Second, with these bounds as hypotheses, graze::range_bound and Gappa
// bound the result of the formula.
//
// Formulas are homogeneous, so |Δx| = |Δu| = 1 (or |w| = |u| = |n| = 1) loses no generality. Then a = 1, c = 1 - R² and
// D = h² - c. So errors that depend on R² depend on c, and c, h and D are related.
#pragma once

#include <graze/analysis/error_bound.hpp>
#include <graze/analysis/gappa_term.hpp>
#include <graze/analysis/range_bound.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/roots.hpp>
#include <graze/number/sqrt_extension.hpp>

#include <array>
#include <cstdio>
#include <string>

namespace bounds {

[[nodiscard]] constexpr double power_of_two(int n) {
    double x = 1;
    for (; n < 0; ++n) {
        x /= 2;
    }
    for (; n > 0; --n) {
        x *= 2;
    }
    return x;
}

// A formula's error in units u: `fixed` + `growing` R². It allows for the norms of the rounded vectors, which differ
// from those of the exact ones by a factor of 1 + u to a power below 16.
struct error_by_radius {
    double fixed = 0;
    double growing = 0;
    [[nodiscard]] constexpr double at(double square_of_radius) const { return fixed + growing * square_of_radius; }
};
template <class F, int N, int Digits>
inline constexpr error_by_radius error_of_balls = [] {
    using bound = graze::basic_error_bound<Digits>;
    const auto with_radius = [](double r) {
        const auto dx = graze::bounded_vector<N>(bound::rounded_input({1, 0, 0}));
        const auto du = graze::bounded_vector<N>(bound::rounded_input({0, 1, 0}));
        const bound one = bound::rounded_input({1, 0, 0});
        return F{}(graze::relative_motion{dx, du, bound(r, r * one.error, {1, 0, 0})}).error * (1 + 16 * bound::unit);
    };
    return error_by_radius{with_radius(0), with_radius(1) - with_radius(0)};
}();
template <class F, int N, int Digits>
inline constexpr double error_of_plane = [] {
    using bound = graze::basic_error_bound<Digits>;
    return F{}(graze::plane_motion{graze::bounded_vector<N>(bound::rounded_input({1, 0, 0})),
                                   graze::bounded_vector<N>(bound::exact_input({0, 1, 0})),
                                   graze::bounded_vector<N>(bound::exact_input({0, 0, 1})),
                                   bound::exact_input({1, 0, 0})})
               .error *
           (1 + 16 * bound::unit);
}();
struct square_of_normal {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(m.n);
    }
};

// How finely the domain is divided. D is at 2^(1-k), since the least D is the worst. g = -h, g >= √D, is divided into
// this many pieces for each factor of √2. Gappa's pieces are smaller.
inline constexpr int pieces_of_compiler = 3;
inline constexpr int pieces_of_gappa = 4;
[[nodiscard]] constexpr double ratio_of(int pieces) { return pieces == 3 ? 1.122462 : 1.0905077; }
// The ends of the pieces of g, from √2^-k on; k is even.
template <class F>
constexpr void for_each_piece(int k, int pieces, F f) {
    double end = power_of_two(-k / 2);
    for (int i = 0; i < k * pieces; ++i) {
        const double next = i + 1 == k * pieces ? 1 : end * ratio_of(pieces);
        f(end, next);
        end = next;
    }
}

// The largest error of τ over all pieces.
template <class F, int N, int Digits>
[[nodiscard]] constexpr double staged_root(int k) {
    using bound = graze::range_bound<Digits>;
    constexpr error_by_radius of_c = error_of_balls<graze::coefficient_c, N, Digits>;
    constexpr error_by_radius of_h = error_of_balls<graze::coefficient_h, N, Digits>;
    constexpr error_by_radius of_d = error_of_balls<F, N, Digits>;
    double worst = 0;
    for (const bool is_least : {true, false}) {
        const double d_low = power_of_two(is_least ? -k : 1 - k);
        const double d_high = is_least ? power_of_two(1 - k) : 1;
        for_each_piece(k, pieces_of_compiler, [&](double g_low, double g_high) {
            const double least = g_low * g_low - d_high;
            const double most = g_high * g_high - d_low;
            if (most < 0) {
                return; // no c >= 0
            }
            const bound c_exact(least > 0 ? least : 0, most < 1 ? most : 1, 0);
            const double r2 = 1 - c_exact.low;
            const bound c(c_exact.low, c_exact.high, of_c.at(r2));
            const bound h(-g_high, -g_low, of_h.at(r2));
            const double error = graze::root_stable{}(c, h, graze::root(bound(d_low, d_high, of_d.at(r2)))).error;
            worst = error > worst ? error : worst;
        });
    }
    return worst;
}

// A number in Gappa's syntax.
[[nodiscard]] inline std::string text_of(double x) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%a", x);
    return buffer.data();
}
[[nodiscard]] inline std::string text_of(const error_by_radius& e) {
    return text_of(e.fixed) + " + " + text_of(e.growing) + " * (1 - exact_c)";
}

template <class F, int N, int Digits>
[[nodiscard]] std::string staged_root_script(int k, const std::string& unit) {
    graze::gappa_script s(unit);
    const auto c = s.approximate_input("c", "g * g - d", text_of(error_of_balls<graze::coefficient_c, N, Digits>));
    const auto h = s.approximate_input("h", "-g", text_of(error_of_balls<graze::coefficient_h, N, Digits>));
    const auto D = s.approximate_input("D", "d", text_of(error_of_balls<F, N, Digits>));
    s.suppose("exact_c in [0,1]");
    s.suppose("d in [" + text_of(power_of_two(-k)) + ",1]");
    s.suppose("g in [" + text_of(power_of_two(-k / 2)) + ",1]");
    std::string pieces_of_g;
    for_each_piece(k, pieces_of_gappa, [&](double, double end) {
        if (end < 1) {
            pieces_of_g += (pieces_of_g.empty() ? "" : ",") + text_of(end);
        }
    });
    return s.text(graze::root_stable{}(c, h, graze::root(D)), "?",
                  "d in (" + text_of(power_of_two(1 - k)) + "), g in (" + pieces_of_g + ")");
}

// The time of touch of a plane, for r <= w·n <= 1, w·n >= 1/16 and u·n <= -2^-k.
template <int N, int Digits>
[[nodiscard]] constexpr double staged_touch(int k) {
    using bound = graze::range_bound<Digits>;
    const bound height(0x1p-4, 1, error_of_plane<graze::plane_height, N, Digits>);
    const bound speed(-1, -power_of_two(-k), error_of_plane<graze::plane_speed, N, Digits>);
    const bound nn(1, 1, error_of_plane<square_of_normal, N, Digits>);
    const bound reach = bound(0, 1, 0) * graze::root(nn);
    return graze::plane_touch_time{}(height, speed, reach).error;
}
template <int N, int Digits>
[[nodiscard]] std::string staged_touch_script(int k, const std::string& unit) {
    graze::gappa_script s(unit);
    const auto height = s.approximate_input("height", "w", text_of(error_of_plane<graze::plane_height, N, Digits>));
    const auto speed = s.approximate_input("speed", "v", text_of(error_of_plane<graze::plane_speed, N, Digits>));
    const auto nn = s.approximate_input("nn", "1", text_of(error_of_plane<square_of_normal, N, Digits>));
    const auto r = s.exact_input("r");
    s.suppose("r in [0,1]");
    s.suppose("w in [0x1p-4,1]");
    s.suppose("w - r in [0,1]");
    s.suppose("v in [-1," + text_of(-power_of_two(-k)) + "]");
    return s.text(graze::plane_touch_time{}(height, speed, r * graze::root(nn)));
}

} // namespace bounds
