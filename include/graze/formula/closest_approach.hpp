// D of Eq. (12) by way of the closest approach, in two forms that engines use. They are equal to the forms of
// discriminant.hpp in exact arithmetic. Both divide by a = |Δu|², which must not be 0.
#pragma once

#include <graze/formula/quadratic.hpp>

namespace graze::inline v0_1 {

// m = Δx - (h/a) Δu: from b to a when the two are closest, at t = -h/a. Lengths.
struct closest_approach {
    template <int N, field_number T>
    [[nodiscard]] constexpr vec<N, T> operator()(const relative_motion<N, T, T, T>& motion) const {
        const T at = coefficient_h{}(motion) / coefficient_a{}(motion);
        return make_vec<N>([&](int i) { return T(motion.dx[i] - at * motion.du[i]); });
    }
};

// D = a (R² - |m|²), as Box2D casts a ray at a circle. It cancels for grazing balls, and m does for distant ones.
struct discriminant_closest {
    template <int N, field_number T>
    [[nodiscard]] constexpr T operator()(const relative_motion<N, T, T, T>& motion) const {
        const vec<N, T> m = closest_approach{}(motion);
        return coefficient_a{}(motion) * (motion.R * motion.R - graze::squared_norm(m));
    }
};

// D = a (R + l)(R - l) with l = |m|, as pbrt-v4 meets spheres: it subtracts lengths, not their squares. For types with
// a root alone.
struct discriminant_factored {
    template <int N, field_number T>
    requires has_sqrt<T>
    [[nodiscard]] constexpr T operator()(const relative_motion<N, T, T, T>& motion) const {
        const T l = number_traits<T>::sqrt(graze::squared_norm(closest_approach{}(motion)));
        return coefficient_a{}(motion) * ((motion.R + l) * (motion.R - l));
    }
};

} // namespace graze::inline v0_1
