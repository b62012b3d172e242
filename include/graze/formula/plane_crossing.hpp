// A ball against an infinite plane: Eqs. (31) to (33), completed with the ball's radius and side.
#pragma once

#include <graze/formula/quadratic.hpp>
#include <graze/shape/plane.hpp>

namespace graze::inline v0_1 {

// A ball seen from a plane: w = x - p₀ and u = the ball's velocity, n the plane's normal, r the ball's radius.
template <int N, class X, class U, class E, class S>
struct plane_motion {
    vec<N, X> w;
    vec<N, U> u;
    vec<N, E> n;
    S r;
};
template <int N, class X, class U, class E, class S>
plane_motion(vec<N, X>, vec<N, U>, vec<N, E>, S) -> plane_motion<N, X, U, E, S>;

template <int N, class T>
[[nodiscard]] constexpr auto relative_motion_of(const ball<N, T>& b, const plane<N, T>& p) {
    return plane_motion{b.position - p.point, b.velocity, p.normal, b.radius};
}

// w·n: the centre's height above the plane, times |n|.
struct plane_height {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::dot(m.w, m.n);
    }
};

// u·n: how fast that grows.
struct plane_speed {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::dot(m.u, m.n);
    }
};

// (w·n)² - r² n·n: negative when the ball cuts the plane.
struct plane_clearance {
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        const auto height = plane_height{}(m);
        return height * height - m.r * m.r * graze::squared_norm(m.n);
    }
};

// A quadratic whose smaller root is the time of touch: the linear equation of that time, squared.
template <int N, class X, class U, class E, class S>
[[nodiscard]] constexpr auto quadratic_of(const plane_motion<N, X, U, E, S>& m) {
    const auto height = plane_height{}(m);
    const auto speed = plane_speed{}(m);
    return quadratic{speed * speed, height * speed, plane_clearance{}(m)};
}

// (33) as printed: the time at which the ball's centre reaches the plane.
struct centre_crossing_time {
    template <class K, class V>
    [[nodiscard]] constexpr auto operator()(const K& height, const V& speed) const {
        return -height / speed;
    }
};

// (33) completed: the time at which the ball touches the plane, ((p₀ - x)·n ± r|n|)/(u·n), with the sign of (x - p₀)·n.
// reach = r|n|.
struct plane_touch_time {
    template <class K, class V, class S>
    [[nodiscard]] constexpr auto operator()(const K& height, const V& speed, const S& reach) const {
        return (graze::sign(height) < 0 ? -(height + reach) : reach - height) / speed;
    }
};

} // namespace graze::inline v0_1
