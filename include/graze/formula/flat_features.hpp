// A ball against a flat, convex thing: a segment in the plane, a parallelogram or a triangle in space.
//
// Seen along a line with direction g through its centre, the ball is a point and the thing a polygon. The line crosses
// the thing's plane at λ_i = at_i/(g·n), both by one determinant (Cramer's rule for w = Σ λ_i e_i - t g), and passes
// the line of an edge d at |d·(w × g)|/|d × g|, where d·(w × g) is a sum of at_i and g·n. The way g = u tells what the
// ball comes to; g = n tells what it is next to now.
#pragma once

#include <graze/formula/wall_features.hpp>

#include <algorithm>
#include <array>

namespace graze::inline v0_1 {

// A ball seen from a flat thing's corner: w = x - corner and u the ball's velocity.
template <int N, class T>
struct flat_motion {
    vec<N, T> w, u;
    std::array<vec<N, T>, N - 1> e;
    T r;
    bool is_triangle;
};

// Borders and corners by number. A border of a segment is its corner. In space: of a parallelogram border 2i + far is
// the edge at λ_i = far, and corner λ_0 + 2 λ_1 where two of them meet; a triangle has borders 0 and 2 alike, and 1, at
// λ_0 + λ_1 = 1, in the place of the parallelogram's.
[[nodiscard]] constexpr int borders_of(int dimension, bool is_triangle) noexcept {
    return dimension == 2 ? 2 : is_triangle ? 3 : 4;
}
struct border_ends {
    int start, end;
};
[[nodiscard]] constexpr border_ends ends_of_border(int k, bool is_triangle) noexcept {
    return k == 0   ? border_ends{0, 2}
           : k == 1 ? border_ends{1, is_triangle ? 2 : 3}
           : k == 2 ? border_ends{0, 1}
                    : border_ends{2, 3};
}
// The other border that ends in a corner of border k.
[[nodiscard]] constexpr int other_border(int corner, int k, bool is_triangle) noexcept {
    if (is_triangle) {
        return (corner == 0 ? 2 : corner == 1 ? 3 : 1) - k;
    }
    return k < 2 ? 2 + corner / 2 : corner % 2;
}

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

// The same of a speed: how fast what moves by pull_i along the sides moves inwards.
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

// What is known without looking at features. For the points q of the thing (x - q)·u goes from wu - ahead to wu -
// behind.
template <class T>
struct flat_extent {
    T wu, ahead, behind;
};
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_extent<T> extent_of(const flat_motion<N, T>& m) {
    const T zero(0);
    const T first = graze::dot(m.u, m.e[0]);
    const T above = graze::larger(zero, first), below = graze::smaller(zero, first);
    if constexpr (N == 2) {
        return {graze::dot(m.w, m.u), above, below};
    } else {
        const T second = graze::dot(m.u, m.e[1]);
        return m.is_triangle
                   ? flat_extent<T>{graze::dot(m.w, m.u), graze::larger(above, second), graze::smaller(below, second)}
                   : flat_extent<T>{graze::dot(m.w, m.u), above + graze::larger(zero, second),
                                    below + graze::smaller(zero, second)};
    }
}
// |e₀ × e₁|², positive if the edges are not parallel.
template <int N, class T>
struct flat_edges {
    T first, between, second;
};
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_edges<N, T> edges_of(const flat_motion<N, T>& m) {
    const auto& last = m.e[static_cast<std::size_t>(N - 2)];
    return {graze::squared_norm(m.e[0]), graze::dot(m.e[0], last), graze::squared_norm(last)};
}
struct edges_span {
    template <int N, class T>
    [[nodiscard]] constexpr T operator()(const flat_edges<N, T>& x) const {
        return N == 2 ? x.first : T(x.first * x.second - x.between * x.between);
    }
};
struct recedes_from_all {
    template <class H>
    [[nodiscard]] constexpr auto operator()(const H& x) const {
        return x.wu - x.ahead;
    }
};
struct recedes_from_any {
    template <class H>
    [[nodiscard]] constexpr auto operator()(const H& x) const {
        return x.wu - x.behind;
    }
};
// All of the thing is within √diagonal/2 of its middle (of a triangle: the parallelogram's), from which the centre is
// middle/2. The centre's line passes it at more than r if |middle × u|² > (20 r² + 5/4 diagonal) u·u, since (2r + d)²
// <= 20 r² + 5/4 d². Four times either side, in whole numbers.
template <int N, class T>
struct flat_hull {
    vec<N, T> middle, u;
    T r, diagonal;
};
template <int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_hull<N, T> hull_of(const flat_motion<N, T>& m,
                                                                           const flat_edges<N, T>& e) {
    const vec<N, T> from_first = m.w + (m.w - m.e[0]);
    if constexpr (N == 2) {
        return {from_first, m.u, m.r, e.first};
    } else {
        return {from_first - m.e[1], m.u, m.r,
                e.first + e.second + graze::twice(graze::larger(e.between, T(-e.between)))};
    }
}
struct passes_beside {
    template <class H>
    [[nodiscard]] constexpr auto operator()(const H& x) const {
        const auto four = [](const auto& y) { return graze::twice(graze::twice(y)); };
        const auto rr = four(four(x.r * x.r));
        return four(graze::squared_norm(graze::cross(x.middle, x.u))) -
               (four(rr) + rr + four(x.diagonal) + x.diagonal) * graze::squared_norm(x.u);
    }
};

// w·n, u·n and (w·n)² - r² n·n of the way.
struct way_height {
    template <class W>
    [[nodiscard]] constexpr auto operator()(const W& x) const {
        return x.height;
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
// A border as it stands here has the widest bound of all.
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
// When the ball touches the face it is inside of the border by O |n| - r I, times |u·n|, for O = inside_border of a
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

// A ball and the line of a border, which has the direction d, seen from the border's start; of a corner d leads inwards
// along a border. inside: O, inward: I, speed: u·n.
template <class T>
struct flat_edge {
    T ww, wd, wu, dd, ud, uu, r;
    T far_wd, far_wu; // seen from the end
    T inside, inward, speed;
};
template <int N, class T>
[[nodiscard]] constexpr flat_edge<T> edge_of(const vec<N, T>& w, const vec<N, T>& u, const vec<N, T>& d, const T& r,
                                             const T& inside, const T& inward, const T& speed) {
    const T wd = graze::dot(w, d), wu = graze::dot(w, u), dd = graze::dot(d, d), ud = graze::dot(u, d);
    return {graze::dot(w, w), wd, wu, dd, ud, graze::dot(u, u), r, wd - dd, wu - ud, inside, inward, speed};
}

// Where along the border it is nearest to the centre's line, times |u × d|²: from the start and from the end.
struct nearest_from_start {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wd * x.uu - x.ud * x.wu;
    }
};
struct nearest_from_end {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.far_wd * x.uu - x.ud * x.far_wu;
    }
};
// Where along the border it is nearest to the centre now, times d·d.
struct foot_from_start {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wd;
    }
};
struct foot_from_end {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.far_wd;
    }
};
// h and c of the border's line: ⟨w × d, u × d⟩ and |w × d|² - r² d·d.
struct border_h {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * x.wu - x.wd * x.ud;
    }
};
struct border_c {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * (x.ww - x.r * x.r) - x.wd * x.wd;
    }
};
// |u × d|², and D over d·d: r² |u × d|² - O².
struct border_a {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * x.uu - x.ud * x.ud;
    }
};
struct border_discriminant {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.r * x.r * border_a{}(x)-x.inside * x.inside;
    }
};
// D itself.
struct border_whole_discriminant {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.dd * border_discriminant{}(x);
    }
};
// h, c and D of the corner.
struct corner_h {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wu;
    }
};
struct corner_c {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.ww - x.r * x.r;
    }
};
struct corner_discriminant {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.wu * x.wu - x.uu * corner_c{}(x);
    }
};

// When the ball touches the border's line, the foot is at (T √(d·d) - u·d √D)/(|u × d|² √(d·d)) for T =
// nearest_from_start, from the end likewise, and the ball outside of the border where (u·n) O √(d·d) - I √D <= 0. When
// it touches the corner, it is behind it along d where T - u·d √D <= 0. These are the numbers without roots and the
// norms.
template <class Nearest>
struct touch_along_norm {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        const auto t = Nearest{}(x);
        return t * t * x.dd - x.ud * x.ud * border_discriminant{}(x);
    }
};
struct direction_speed { // u·d
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.ud;
    }
};
struct touch_outside {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.speed * x.inside;
    }
};
struct touch_inward {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        return x.inward;
    }
};
struct touch_outside_norm {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        const auto t = x.speed * x.inside;
        return t * t * x.dd - x.inward * x.inward * border_discriminant{}(x);
    }
};
struct touch_behind_norm {
    template <class E>
    [[nodiscard]] constexpr auto operator()(const E& x) const {
        const auto t = nearest_from_start{}(x);
        return t * t - x.ud * x.ud * corner_discriminant{}(x);
    }
};

} // namespace graze::inline v0_1
