// A ball and a flat, convex shape: a segment in the plane, a parallelogram or a triangle in space.
#pragma once

#include <graze/linear/vec.hpp>

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

// The centre from corner i.
template <int N, class T>
[[nodiscard]] constexpr vec<N, T> centre_from(const flat_motion<N, T>& m, int corner) {
    if constexpr (N == 2) {
        return corner == 0 ? m.w : m.w - m.e[0];
    } else {
        return corner == 0 ? m.w : corner == 1 ? m.w - m.e[0] : corner == 2 ? m.w - m.e[1] : m.w - m.e[0] - m.e[1];
    }
}
// A border's direction from its start to its end.
template <int N, class T>
[[nodiscard]] constexpr vec<N, T> direction_of_border(const flat_motion<N, T>& m, int k) {
    return k >= 2 ? m.e[0] : k == 1 && m.is_triangle ? m.e[1] - m.e[0] : m.e[1];
}
// The direction inwards along border k from a corner that is one of its ends.
template <int N, class T>
[[nodiscard]] constexpr vec<N, T> direction_from(const flat_motion<N, T>& m, int corner, int k) {
    if constexpr (N == 2) {
        return k == 0 ? m.e[0] : -m.e[0];
    } else {
        const vec<N, T> d = direction_of_border(m, k);
        return ends_of_border(k, m.is_triangle).start == corner ? d : -d;
    }
}

} // namespace graze::inline v0_1
