// When a ball touches a plane, in doubles with a bound on the error: of a scene in a box every event asks it.
#pragma once

#include <graze/pair/rounded_motion.hpp>
#include <graze/pair/wall_signs.hpp>
#include <graze/time/enclosure.hpp>

namespace graze::inline v0_1::detail {

// Around τ = (|w·n| - r|n|)/|u·n| of a ball that certainly hits the plane at a later time. Unknown where the doubles
// leave it open.
//
// u = 2^-52, in any rounding mode, contracted or not. With H = Σ|w_i n_i| and S = Σ|u_i n_i| as computed, N <= 3 terms:
//   |w·n| is off by at most 8uH: each w_i is rounded once, each product once, and summed twice;
//   |u·n| by at most 8uS =: e, where e <= |u·n|/8 is asked for;
//   r|n| by at most 2^-49 of itself: the squares of n and their sum by 3u, the root, checked by its square, by 2^-51;
//   the quotient t̂ is checked: |t̂ |u·n| - gap| <= 2^-50 gap, and gap <= H.
// So |τ - t̂| <= (2^-49 H + 2^-49 r|n| + u gap + 2^-50 gap + t̂ e)/(|u·n| - e) <= 8/7 (2^-48 (H + r|n|) + 2^-49 t̂
// S)/|u·n|; 3/2 of twice the second term and of the first covers the roundings of the expression itself. In range
// nothing underflows that counts.
template <int N, class T>
[[nodiscard]] inline enclosure enclose_touch(const ball<N, T>& b, const plane<N, T>& p) noexcept {
    const auto m = rounded_motion(b, p);
    if (!usable<T>(magnitudes_of(m))) {
        return {};
    }
    double height_scale = 0;
    double speed_scale = 0;
    for (int i = 0; i < N; ++i) {
        height_scale += std::fabs(m.w[i] * m.n[i]);
        speed_scale += std::fabs(m.u[i] * m.n[i]);
    }
    const double normal2 = graze::squared_norm(m.n);
    const double length = fence(std::sqrt(normal2));
    const double speed = std::fabs(plane_speed{}(m));
    const double reach = m.r * length;
    const double gap = fence(std::fabs(plane_height{}(m)) - reach);
    const double time = fence(gap / speed);
    const bool good = std::fabs(length * length - normal2) <= 0x1p-50 * normal2 &&
                      std::fabs(time * speed - gap) <= 0x1p-50 * gap && speed > 0x1p-46 * speed_scale;
    if (!good) {
        return {};
    }
    const double error = 1.5 * (0x1p-48 * (height_scale + reach) + 0x1p-48 * time * speed_scale) / speed;
    const double lower = time - error;
    return lower > 0 ? enclosure{time, error} : enclosure{};
}

} // namespace graze::inline v0_1::detail
