// What can be decided about a ball and a flat shape without its features.
#pragma once

#include <graze/formula/flat_motion.hpp>
#include <graze/number/traits.hpp>

namespace graze::inline v0_1 {

// The range of (x - q)·u for all points q of the shape, without looking at its features: from wu - ahead to
// wu - behind.
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
// All of the shape is within √diagonal/2 of its middle (for a triangle, the parallelogram's), from which the centre is
// middle/2. The centre's line passes it at more than r if |middle × u|² > (20 r² + 5/4 diagonal) u·u, since (2r + d)²
// <= 20 r² + 5/4 d². Both sides times four, in whole numbers.
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

} // namespace graze::inline v0_1
