// The quantities whose rounding errors are bounded: each has the library's own formula, the domain on which it is
// bounded, and the quantities that it is computed from.
#pragma once

#include "sources.hpp"
#include "staged.hpp"

#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/roots.hpp>

#include <string>
#include <tuple>
#include <type_traits>

namespace bounds {

// Two balls. Δx, Δu and R were rounded once each.
template <int N, class Source>
[[nodiscard]] constexpr auto balls(Source& s) {
    auto dx = differences<N>(s, kind::length);
    auto du = differences<N>(s, kind::velocity);
    auto radii = s.difference(kind::length);
    return graze::relative_motion{dx, du, radii};
}

// A ball and a plane: w was rounded once.
template <int N, class Source>
[[nodiscard]] constexpr auto ball_and_plane(Source& s) {
    auto w = differences<N>(s, kind::length);
    auto u = inputs<N>(s, kind::velocity);
    auto n = inputs<N>(s, kind::normal);
    auto r = s.input(kind::length);
    return graze::plane_motion{w, u, n, r};
}

// A formula of two balls' motion.
template <class F>
struct of_balls {
    static constexpr bool of_two_balls = true;
    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s) {
        return F{}(balls<N>(s));
    }
};
template <class F>
struct of_plane {
    static constexpr bool of_two_balls = false;
    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s) {
        return F{}(ball_and_plane<N>(s));
    }
};

struct square_of_radius_sum {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return m.R * m.R;
    }
};
struct square_of_h {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto h = graze::coefficient_h{}(m);
        return h * h;
    }
};
struct a_times_c {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::coefficient_a{}(m)*graze::coefficient_c{}(m);
    }
};
struct halved_of_motion {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::discriminant_halved{}(graze::quadratic_of(m));
    }
};
struct textbook_of_motion {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::discriminant_textbook{}(graze::quadratic_of(m));
    }
};
struct kahan_of_motion { // its exact value is D, even in a type without fused multiply-adds
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto q = graze::quadratic_of(m);
        if constexpr (graze::has_fma<std::remove_cvref_t<decltype(q.a)>>) {
            return graze::discriminant_kahan{}(q);
        } else {
            return graze::discriminant_halved{}(q);
        }
    }
};

struct radii : of_balls<square_of_radius_sum> {
    static constexpr const char* name = "R²";
    static constexpr bool has_vectors = false;
    static constexpr degrees degree{2, 0, 0};
    using parts = std::tuple<>;
};
struct a : of_balls<graze::coefficient_a> {
    static constexpr const char* name = "a";
    static constexpr degrees degree{0, 2, 0};
    using parts = std::tuple<>;
};
struct h : of_balls<graze::coefficient_h> {
    static constexpr const char* name = "h";
    static constexpr degrees degree{1, 1, 0};
    using parts = std::tuple<>;
};
struct c : of_balls<graze::coefficient_c> {
    static constexpr const char* name = "c";
    static constexpr degrees degree{2, 0, 0};
    using parts = std::tuple<radii>;
};
struct h2 : of_balls<square_of_h> {
    static constexpr const char* name = "h²";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<h>;
};
struct ac : of_balls<a_times_c> {
    static constexpr const char* name = "a c";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<a, c>;
};
struct textbook : of_balls<textbook_of_motion> {
    static constexpr const char* name = "4D, textbook";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<h2, ac>;
};
struct halved : of_balls<halved_of_motion> {
    static constexpr const char* name = "D, halved";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<h2, ac>;
};
struct kahan : of_balls<kahan_of_motion> {
    static constexpr const char* name = "D, Kahan";
    static constexpr const char* step = "error of a c";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<h2, ac>;
};
struct lagrange : of_balls<graze::discriminant_lagrange> {
    static constexpr const char* name = "D, Lagrange";
    static constexpr const char* step = "\\|Δx × Δu\\|²";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<radii, a>;
};

// τ of two balls where D >= 2^-K a |Δx|², h < 0 and c >= 0. It uses the filters' bounds of c, h and D, and staged.hpp
// for the effect of quotients and roots.
template <class F, int K>
struct time {
    static constexpr bool of_two_balls = true;
    static constexpr const char* step = "√D";
    static constexpr degrees degree{1, -1, 0};

    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s) {
        using number = typename Source::number;
        using real = graze::root_type<number>;
        const auto m = balls<N>(s);
        const number c(graze::coefficient_c{}(m));
        const number h(graze::coefficient_h{}(m));
        const number d(F{}(m));
        s.require([&] {
            const number least(graze::coefficient_a{}(m)*graze::squared_norm(m.dx));
            return graze::sign(h) < 0 && graze::sign(c) >= 0 && graze::sign(number(power_of_two(K)) * d - least) >= 0 &&
                   graze::sign(least) > 0;
        });
        return graze::root_stable{}(real(c), real(h), graze::root(d));
    }
    template <int N, int Digits>
    [[nodiscard]] static constexpr double compiled() {
        return staged_root<F, N, Digits>(K);
    }
    template <int N, int Digits>
    [[nodiscard]] static std::string script(const std::string& unit) {
        return staged_root_script<F, N, Digits>(K, unit);
    }
};
template <int K>
struct time_lagrange : time<graze::discriminant_lagrange, K> {
    using parts = std::tuple<c, h, lagrange>;
    static inline const std::string text = "τ, Lagrange, D ≥ 2^-" + std::to_string(K);
    static inline const char* const name = text.c_str();
};
template <int K>
struct time_halved : time<halved_of_motion, K> {
    using parts = std::tuple<c, h, halved>;
    static inline const std::string text = "τ, halved, D ≥ 2^-" + std::to_string(K);
    static inline const char* const name = text.c_str();
};

struct height : of_plane<graze::plane_height> {
    static constexpr const char* name = "w·n";
    static constexpr degrees degree{1, 0, 1};
    using parts = std::tuple<>;
};
struct clearance : of_plane<graze::plane_clearance> {
    static constexpr const char* name = "(w·n)² − r² n·n";
    static constexpr degrees degree{2, 0, 2};
    using parts = std::tuple<height>;
};

// (33) completed, for a ball apart from the plane and above it by at least |w||n|/16, which approaches with |u·n| >=
// 2^-K |u||n|.
template <int K>
struct touch {
    static inline const std::string text = "t, plane, \\|u·n\\| ≥ 2^-" + std::to_string(K);
    static inline const char* const name = text.c_str();
    static constexpr const char* step = "(r √n·n − w·n)/(u·n)";
    static constexpr bool of_two_balls = false;
    static constexpr degrees degree{1, -1, 0};
    using parts = std::tuple<height>;

    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s) {
        using number = typename Source::number;
        using real = graze::root_type<number>;
        const auto m = ball_and_plane<N>(s);
        const number height(graze::plane_height{}(m));
        const number speed(graze::plane_speed{}(m));
        const number nn(graze::squared_norm(m.n));
        s.require([&] {
            const number uu(graze::squared_norm(m.u));
            return graze::sign(height) > 0 && graze::sign(speed) < 0 && graze::sign(m.r) >= 0 &&
                   graze::sign(number(graze::plane_clearance{}(m))) >= 0 &&
                   graze::sign(number(256) * height * height - graze::squared_norm(m.w) * nn) >= 0 &&
                   graze::sign(number(power_of_two(2 * K)) * speed * speed - uu * nn) >= 0 && graze::sign(uu * nn) > 0;
        });
        return graze::plane_touch_time{}(real(height), real(speed), real(m.r) * graze::root(nn));
    }
    template <int N, int Digits>
    [[nodiscard]] static constexpr double compiled() {
        return staged_touch<N, Digits>(K);
    }
    template <int N, int Digits>
    [[nodiscard]] static std::string script(const std::string& unit) {
        return staged_touch_script<N, Digits>(K, unit);
    }
};

using all = std::tuple<radii, a, h, c, h2, ac, textbook, halved, kahan, lagrange, time_lagrange<2>, time_lagrange<6>,
                       time_lagrange<10>, time_halved<6>, height, clearance, touch<2>, touch<6>, touch<10>>;

} // namespace bounds
