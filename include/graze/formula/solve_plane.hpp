// graze::solve for a ball and an infinite plane.
#pragma once

#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/solution.hpp>

namespace graze::inline v0_1 {

// The whole solution in T, by Eq. (33) completed. The variant has no effect on a plane's linear equation; it is a
// parameter so that all pair kinds are called alike. A plane is never missed and never grazed. Does not check its
// input.
template <variant V = variant::lagrange, root_form F = root_form::stable, number T, int N>
requires field_number<T>
[[nodiscard]] constexpr wall_solution<N, T> solve(const ball<N, T>& b, const plane<N, T>& p) {
    using real = root_type<T>;
    wall_solution<N, T> s;
    const auto m = relative_motion_of(b, p);
    const T height = plane_height{}(m);
    const T speed = plane_speed{}(m);
    s.what = encounter_of([&] { return graze::sign(height) * graze::sign(speed); },
                          [&] { return graze::sign(T(plane_clearance{}(m))); }, [] { return 1; });
    if (!is_collision(s.what)) {
        return s;
    }
    const real length = graze::root(T(graze::squared_norm(m.n)));
    if (s.what == encounter::hit) {
        s.time = plane_touch_time{}(real(height), real(speed), real(m.r) * length); // (33) completed
    }
    s.position = position_at(detail::as<real>(b.position), detail::as<real>(b.velocity), s.time);
    s.normal = contact_normal(detail::as<real>(m.n), real(graze::sign(height) < 0 ? -length : length));
    const real above = s.what == encounter::hit
                           ? real(m.r)
                           : real(graze::sign(height) < 0 ? T(-height) : height) / length; // the centre's distance
    s.point = position_at(s.position, s.normal, real(-above));
    s.velocity = reflected_unnormalised(detail::as<real>(b.velocity), detail::as<real>(m.n));
    return s;
}

} // namespace graze::inline v0_1
