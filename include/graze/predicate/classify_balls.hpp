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

// What the filter knows of a pair: the encounter if it is certain, and the numbers on which that rests.
struct filtered_balls {
    bool certain = false;
    encounter what = encounter::recede;
    double h = 0, c = 0, discriminant = 0;
    double length2 = 0; // |Δx|² + R²
    double scale = 0;   // |Δu|² length2
};

// In [2^-450, 2^450) for |Δu|² and length2 no product over- or underflows, and what is flushed to zero is below 2^-120
// of its scale. NaN and infinities are out of range.
template <int N, class T>
[[nodiscard]] inline filtered_balls filter_balls(const ball<N, T>& a, const ball<N, T>& b) noexcept {
    using constant = ball_filter<N, T>;
    filtered_balls r;
    const auto m = rounded_motion(a, b);
    const auto q = quadratic_of(m);
    const double velocity2 = q.a;
    r.h = q.h;
    r.length2 = squared_norm(m.dx) + m.R * m.R;
    r.scale = velocity2 * r.length2;
    if (r.h * r.h > constant::h_squared * r.scale && within_powers<450>(velocity2) && within_powers<450>(r.length2) &&
        plain_radius(a.radius) && plain_radius(b.radius)) {
        if (r.h > 0) {
            r.certain = true;
            return r;
        }
        r.c = q.c;
        r.discriminant = discriminant_halved{}(q);
        const bool certain_c = std::fabs(r.c) > constant::c * r.length2;
        const bool certain_d = std::fabs(r.discriminant) > constant::discriminant * r.scale;
        r.certain = certain_c && (certain_d || r.c < 0);
        r.what = r.c < 0 ? encounter::overlap : r.discriminant < 0 ? encounter::miss : encounter::hit;
    }
    return r;
}

// f(motion) with the exact relative motion of two balls whose values have been checked.
template <int N, class T, class F>
[[nodiscard]] constexpr auto with_exact_balls(const ball<N, T>& a, const ball<N, T>& b, F f) {
    check(a, "ball a");
    check(b, "ball b");
    return with_exact_motion<two_balls<N>>(lift_row<two_balls<N>>(two_balls<N>::pack(a, b)), f);
}

// The encounter by the signs of exact numbers.
struct exact_encounter {
    template <class M>
    [[nodiscard]] constexpr encounter operator()(const M& m) const {
        const auto h = coefficient_h{}(m);
        const auto c = coefficient_c{}(m);
        return encounter_of([&] { return sign(h); }, [&] { return sign(c); },
                            [&] {
                                return sign(discriminant_halved{}(quadratic{coefficient_a{}(m), h, c}));
                            });
    }
};

} // namespace detail

// Whether two balls meet, exactly, for every finite input. Throws std::domain_error that names the ball and the field
// when an input is not finite or a radius is negative; in a constant expression such input does not compile. The
// observer is told which stage decided. Eqs. (10) to (12), corrected.
template <int N, class T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr encounter classify(const ball<N, T>& a, const ball<N, T>& b, Observer&& observer = {}) {
    if (!std::is_constant_evaluated()) {
        if (const auto filtered = detail::filter_balls(a, b); filtered.certain) {
            observer(stage::filter);
            return filtered.what;
        }
    }
    observer(stage::exact);
    return detail::with_exact_balls(a, b, detail::exact_encounter{});
}

} // namespace graze
