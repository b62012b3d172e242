// What becomes of two balls, exactly.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/predicate/input_check.hpp>
#include <graze/predicate/pair.hpp>
#include <graze/predicate/rounded_motion.hpp>
#include <graze/predicate/stage.hpp>

#include <cmath>
#include <type_traits>

namespace graze {

namespace detail {

struct halved_of_motion {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return discriminant_halved{}(quadratic_of(m));
    }
};

// The constants of the three signs, each against the product of scales that has its degree: c against length², D
// against length²·velocity², and h², whose root is taken away by squaring, against the same.
template <int N, class T>
struct ball_filter {
    static constexpr double h = filter_constant(coefficient_h{}, ball_bounds<N, T>::value());
    static constexpr double h_squared = h * h * error_bound_slack;
    static constexpr double c = filter_constant(coefficient_c{}, ball_bounds<N, T>::value());
    static constexpr double discriminant = filter_constant(halved_of_motion{}, ball_bounds<N, T>::value());

    static_assert(filter_degrees(coefficient_h{}, ball_bounds<N, T>::value()) == error_bound::degrees{1, 1, 0});
    static_assert(filter_degrees(coefficient_c{}, ball_bounds<N, T>::value()) == error_bound::degrees{2, 0, 0});
    static_assert(filter_degrees(halved_of_motion{}, ball_bounds<N, T>::value()) == error_bound::degrees{2, 2, 0});
};

// Σ|Δx_i Δu_i|: the scale against which h is rounded, before Cauchy and Schwarz make it length·velocity.
template <int N>
[[nodiscard]] inline double magnitude_of_products(const vec<N, double>& x, const vec<N, double>& y) noexcept {
    double sum = std::fabs(x[0] * y[0]);
    for (int i = 1; i < N; ++i) {
        sum += std::fabs(x[i] * y[i]);
    }
    return sum;
}

template <int N, class T>
[[nodiscard]] constexpr encounter classify_balls_exactly(const ball<N, T>& a, const ball<N, T>& b) {
    check(a, "ball a");
    check(b, "ball b");
    return with_exact_motion<two_balls<N>>(lift_row<two_balls<N>>(two_balls<N>::pack(a, b)), [](const auto& m) {
        const auto h = coefficient_h{}(m);
        const auto c = coefficient_c{}(m);
        return encounter_of([&] { return sign(h); }, [&] { return sign(c); },
                            [&] {
                                return sign(discriminant_halved{}(quadratic{coefficient_a{}(m), h, c}));
                            });
    });
}

} // namespace detail

// Whether two balls meet, exactly, for every finite input. Throws std::domain_error that names the ball and the field
// when an input is not finite or a radius is negative; in a constant expression such input does not compile. The
// observer is told which stage decided. Eqs. (10) to (12), corrected.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const ball<N, T>& a, const ball<N, T>& b, Observer&& observer = {}) {
    if (!std::is_constant_evaluated()) {
        using filter = detail::ball_filter<N, T>;
        const auto m = detail::rounded_motion(a, b);
        const double h = coefficient_h{}(m);
        const double h_bound = filter::h * detail::magnitude_of_products(m.dx, m.du);
        if (detail::plain_radius(a.radius) && detail::plain_radius(b.radius) &&
            detail::within_powers<450>(std::fabs(h))) {
            if (h > h_bound) {
                observer(stage::filter);
                return encounter::recede;
            }
            const auto q = quadratic{coefficient_a{}(m), h, coefficient_c{}(m)};
            const double length2 = squared_norm(m.dx) + m.R * m.R;
            const double discriminant = discriminant_halved{}(q);
            const bool certain_c = std::fabs(q.c) > filter::c * length2;
            const bool certain_d = std::fabs(discriminant) > filter::discriminant * (q.a * length2);
            if (h < -h_bound && certain_c && (certain_d || q.c < 0) && detail::within_powers<450>(q.a) &&
                detail::within_powers<450>(length2)) {
                observer(stage::filter);
                return q.c < 0 ? encounter::overlap : discriminant < 0 ? encounter::miss : encounter::hit;
            }
        }
    }
    observer(stage::exact);
    return detail::classify_balls_exactly(a, b);
}

} // namespace graze
