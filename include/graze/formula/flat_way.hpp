// Where a ball's path crosses the plane of a flat shape.
//
// Seen along a line with direction g through its centre, the ball is a point and the shape a polygon. The line crosses
// the plane at λ_i = at_i/(g·n), both by one determinant (Cramer's rule for w = Σ λ_i e_i - t g). With g = u this tells
// what the ball comes to, with g = n what it is next to now.
#pragma once

#include <graze/formula/flat_motion.hpp>
#include <graze/formula/wall_features.hpp>

namespace graze::inline v0_1 {

// Where a line crosses the plane: a number for each border that is negative outside of it, if g·n > 0.
template <int N, class T>
[[nodiscard]] constexpr T inside_of_border(int k, bool is_triangle, const T& facing, const std::array<T, N - 1>& at) {
    if constexpr (N == 2) {
        return k == 0 ? at[0] : T(facing - at[0]);
    } else {
        return k == 0        ? at[0]
               : k == 2      ? at[1]
               : k == 3      ? T(facing - at[1])
               : is_triangle ? T(facing - (at[0] + at[1]))
                             : T(facing - at[0]);
    }
}

// The same for a speed: how fast something with the speeds pull_i along the sides moves inwards.
template <int N, class T>
[[nodiscard]] constexpr T inwards_of_border(int k, bool is_triangle, const std::array<T, N - 1>& pull) {
    if constexpr (N == 2) {
        return k == 0 ? pull[0] : T(-pull[0]);
    } else {
        return k == 0        ? pull[0]
               : k == 2      ? pull[1]
               : k == 3      ? T(-pull[1])
               : is_triangle ? T(-(pull[0] + pull[1]))
                             : T(-pull[0]);
    }
}

// The ball's way across the plane of the face, in numbers, with n perpendicular to the edges: height = w·n, speed = u·n
// = facing, at_i, pull_i = u·side_i, how fast λ_i grows, times n·n.
template <int N, class T>
struct flat_way {
    T height, speed, facing, nn, r;
    std::array<T, N - 1> at, pull;
};
template <int N, class T>
[[nodiscard]] constexpr std::array<T, N - 1> along_sides(const vec<N, T>& x, const std::array<vec<N, T>, N - 1>& e) {
    if constexpr (N == 2) {
        return {graze::dot(x, e[0])};
    } else { // x·(e₁ × n) and x·(n × e₀)
        const T a = graze::dot(e[0], e[0]), b = graze::dot(e[0], e[1]), c = graze::dot(e[1], e[1]);
        const T y = graze::dot(x, e[0]), z = graze::dot(x, e[1]);
        return {y * c - z * b, z * a - y * b};
    }
}
template <int N, class T>
[[nodiscard]] constexpr std::array<T, N - 1> crossing_of(const vec<N, T>& w, const vec<N, T>& g,
                                                         const std::array<vec<N, T>, N - 1>& e) {
    if constexpr (N == 2) {
        return {graze::cross(w, g)};
    } else {
        const auto c = graze::cross(w, g);
        return {-graze::dot(c, e[1]), graze::dot(c, e[0])};
    }
}
template <int N, class T>
[[nodiscard]] constexpr flat_way<N, T> way_of(const flat_motion<N, T>& m) {
    const vec<N, T> n = face_normal(m.e);
    const T speed = graze::dot(m.u, n);
    return {graze::dot(m.w, n),   speed, speed, graze::squared_norm(n), m.r, crossing_of(m.w, m.u, m.e),
            along_sides(m.u, m.e)};
}

// Where it is now: the same with g = n, at_i = w·side_i and facing = n·n.
template <int N, class T>
struct flat_place {
    T facing;
    std::array<T, N - 1> at;
};
template <int N, class T>
[[nodiscard]] constexpr flat_place<N, T> place_of(const flat_motion<N, T>& m, const flat_way<N, T>& way) {
    return {way.nn, along_sides(m.w, m.e)};
}

// w·n, u·n and (w·n)² - r² n·n of the way.
struct way_height {
    template <class W>
    [[nodiscard]] constexpr auto operator()(const W& x) const {
        return x.height;
    }
};
struct way_square { // n·n, positive if the edges are not parallel
    template <class W>
    [[nodiscard]] constexpr auto operator()(const W& x) const {
        return x.nn;
    }
};
struct way_speed {
    template <class W>
    [[nodiscard]] constexpr auto operator()(const W& x) const {
        return x.speed;
    }
};
struct way_clearance {
    template <class W>
    [[nodiscard]] constexpr auto operator()(const W& x) const {
        return x.height * x.height - x.r * x.r * x.nn;
    }
};
// Of all borders, the default one has the widest bound.
struct inside_border {
    int k = 1;
    bool is_triangle = true;
    template <template <int, class> class W, int N, class T>
    [[nodiscard]] constexpr T operator()(const W<N, T>& x) const {
        return inside_of_border<N, T>(k, is_triangle, x.facing, x.at);
    }
};
// How fast the ball moves inwards from the border, in the face: u·side.
struct inward_speed {
    int k = 1;
    bool is_triangle = true;
    template <int N, class T>
    [[nodiscard]] constexpr T operator()(const flat_way<N, T>& x) const {
        return inwards_of_border<N, T>(k, is_triangle, x.pull);
    }
};
// When the ball touches the face it is inside of the border by O |n| - r I, times |u·n|, with O = inside_border for
// u·n > 0 and I = inward_speed: with a root, and as the norm O² n·n - r² I².
template <int N, class T>
struct flat_touch {
    T length, facing, r;
    std::array<T, N - 1> at, pull;
};
struct touch_length {
    template <class W>
    [[nodiscard]] constexpr auto operator()(const W& x) const {
        return x.length;
    }
};
struct touch_inside {
    int k = 1;
    bool is_triangle = true;
    template <int N, class T>
    [[nodiscard]] constexpr T operator()(const flat_touch<N, T>& x) const {
        return inside_border{k, is_triangle}(x)*x.length - x.r * inwards_of_border<N, T>(k, is_triangle, x.pull);
    }
};
struct touch_inside_norm {
    int k = 1;
    bool is_triangle = true;
    template <int N, class T>
    [[nodiscard]] constexpr T operator()(const flat_way<N, T>& x) const {
        const T inside = inside_border{k, is_triangle}(x);
        const T slip = x.r * inwards_of_border<N, T>(k, is_triangle, x.pull);
        return inside * inside * x.nn - slip * slip;
    }
};

} // namespace graze::inline v0_1
