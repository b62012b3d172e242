// The quantities whose rounding errors are bounded, each the library's own formula, with the domain on which it is
// bounded and the quantities that it is made of.
#pragma once

#include "sources.hpp"

#include <graze/formula/discriminant.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/roots.hpp>

#include <string>
#include <tuple>

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

// A quantity's domain may come in slices.
inline constexpr int whole = -1;
template <class Q>
inline constexpr int slices_of = [] {
    if constexpr (requires { Q::slices; }) {
        return Q::slices;
    } else {
        return 1;
    }
}();
template <class Q, int N, class Source>
[[nodiscard]] constexpr auto run_slice(Source& s, int slice) {
    if constexpr (requires { Q::slices; }) {
        return Q::template run<N>(s, slice);
    } else {
        return Q::template run<N>(s);
    }
}

// Two balls: Δx, Δu and R were rounded once each.
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
    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s) {
        return F{}(balls<N>(s));
    }
};
template <class F>
struct of_plane {
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
struct square_of_cross {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::squared_norm(graze::cross(m.dx, m.du));
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
struct kahan_of_motion { // its exact value is D, in a type without fused multiply-adds too
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
struct cross2 : of_balls<square_of_cross> {
    static constexpr const char* name = "\\|Δx × Δu\\|²";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<>;
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
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<h2, ac>;
};
struct lagrange : of_balls<graze::discriminant_lagrange> {
    static constexpr const char* name = "D, Lagrange";
    static constexpr degrees degree{2, 2, 0};
    using parts = std::tuple<radii, a, cross2>;
};

// τ where D >= 2^-K length² velocity², h < 0 and c >= 0: then |h| >= √D, since D = h² - ac. Where the largest component
// of a velocity is 1, a >= 1, so that c <= h² and τ <= -h/a <= |h|. Compiler and Gappa are given slices of the domain,
// in each of which |h| is known to a factor of 2, and bound the worst of them.
template <class D, int K, int Half = K / 2>
struct time {
    static_assert(K == 2 * Half);
    static constexpr degrees degree{1, -1, 0};
    using parts = std::tuple<c, h, D>;
    static constexpr int slices = Half + 2;

    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s, int slice = whole) {
        using number = typename Source::number;
        using real = graze::root_type<number>;
        const double low = slice == whole ? power_of_two(-Half) : power_of_two(-slice + 1);
        const double high = slice == whole || 2 * low > N ? N : 2 * low;
        const auto m = balls<N>(s);
        const number c = s.known(graze::coefficient_c{}(m), 0, high * high < N ? high * high : N, {2, 0, 0});
        const number h = s.known(graze::coefficient_h{}(m), -high, -low, {1, 1, 0});
        const number d = s.known(discriminant(m), power_of_two(-K), high * high, {2, 2, 0});
        return s.known(graze::root_stable{}(real(c), real(h), graze::root(d)), 0, high < 2 ? high : 2, degree);
    }
    template <class M>
    [[nodiscard]] static constexpr auto discriminant(const M& m) {
        if constexpr (std::is_same_v<D, lagrange>) {
            return graze::discriminant_lagrange{}(m);
        } else {
            return halved_of_motion{}(m);
        }
    }
};
template <int K>
struct time_lagrange : time<lagrange, K> {
    static inline const std::string text = "τ, Lagrange, D ≥ 2^-" + std::to_string(K);
    static inline const char* const name = text.c_str();
};
template <int K>
struct time_halved : time<halved, K> {
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

// (33) completed, seen from above, where the speed of approach is at least 2^-K velocity·normal and the ball apart.
template <int K>
struct touch {
    static inline const std::string text = "t, plane, \\|u·n\\| ≥ 2^-" + std::to_string(K);
    static inline const char* const name = text.c_str();
    static constexpr degrees degree{1, -1, 0};
    using parts = std::tuple<height>;

    template <int N, class Source>
    [[nodiscard]] static constexpr auto run(Source& s) {
        using number = typename Source::number;
        using real = graze::root_type<number>;
        const auto m = ball_and_plane<N>(s);
        const number height = s.known(graze::plane_height{}(m), 0, N, {1, 0, 1});
        const number speed = s.known(graze::plane_speed{}(m), -N, -power_of_two(-K), {0, 1, 1});
        const number nn = s.known(number(graze::squared_norm(m.n)), 1, N, {0, 0, 2});
        const real reach = real(m.r) * graze::root(nn);
        return s.known(graze::plane_touch_time{}(real(height), real(speed), reach), 0, N / power_of_two(-K), degree);
    }
};

using all =
    std::tuple<radii, a, h, c, h2, ac, cross2, textbook, halved, kahan, lagrange, time_lagrange<2>, time_lagrange<6>,
               time_lagrange<10>, time_halved<6>, height, clearance, touch<2>, touch<6>, touch<10>>;

// How many numbers rounded_source and exact_source take.
struct counting_source {
    using number = graze::range_bound<>;
    std::size_t count = 0;
    [[nodiscard]] constexpr number input(kind) { return ++count, number::exact_input(); }
    [[nodiscard]] constexpr number difference(kind) { return count += 2, number::exact_input(); }
    [[nodiscard]] constexpr number known(const number& x, double low, double high, degrees) {
        return x.within(low, high);
    }
};
template <class Q, int N>
inline constexpr std::size_t inputs_of = [] {
    counting_source s;
    (void)Q::template run<N>(s);
    return s.count;
}();

} // namespace bounds
