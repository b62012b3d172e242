// The decision about two balls by the unchanged formulas, in any number type.
#pragma once

#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/formula/relative_motion.hpp>
#include <graze/shape/ball.hpp>

namespace speed {

template <class T>
[[nodiscard]] graze::vec<3, T> as(const graze::vec<3, double>& x) {
    return graze::make_vec<3>([&](int i) { return T(x[i]); });
}
template <class T>
[[nodiscard]] graze::ball<3, T> as(const graze::ball<3>& x) {
    return {as<T>(x.position), as<T>(x.velocity), T(x.radius), T(x.mass)};
}

// The decision by the formulas in T, without a filter: classify is compared with this.
template <class T>
[[nodiscard]] inline graze::encounter decide(const graze::ball<3, T>& a, const graze::ball<3, T>& b) {
    const auto m = graze::relative_motion_of(a, b);
    const T h = graze::coefficient_h{}(m);
    if (graze::sign(h) >= 0) {
        return graze::encounter::recede;
    }
    const T c = graze::coefficient_c{}(m);
    if (graze::sign(c) < 0) {
        return graze::encounter::overlap;
    }
    const T d = graze::discriminant_halved{}(graze::quadratic<T, T, T>{graze::coefficient_a{}(m), h, c});
    const int s = graze::sign(d);
    return s < 0 ? graze::encounter::miss : s == 0 ? graze::encounter::graze : graze::encounter::hit;
}

} // namespace speed
