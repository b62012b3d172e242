// An order of a scene's parts that depends on their numbers, not on their places in its lists.
#pragma once

#include <graze/scene/records.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

namespace graze::inline v0_1::detail {

// The sign of the lexicographic order of two vectors.
template <int N, class T>
[[nodiscard]] constexpr int order_of(const vec<N, T>& x, const vec<N, T>& y) {
    for (int i = 0; i < N; ++i) {
        if (x[i] < y[i]) {
            return -1;
        }
        if (y[i] < x[i]) {
            return 1;
        }
    }
    return 0;
}
template <class T>
[[nodiscard]] constexpr int order_of(const T& x, const T& y) {
    return x < y ? -1 : y < x ? 1 : 0;
}

template <int N, class T>
[[nodiscard]] constexpr bool precedes(const ball<N, T>& x, const ball<N, T>& y) {
    const int position = order_of(x.position, y.position);
    const int velocity = position != 0 ? position : order_of(x.velocity, y.velocity);
    const int radius = velocity != 0 ? velocity : order_of(x.radius, y.radius);
    return (radius != 0 ? radius : order_of(x.mass, y.mass)) < 0;
}
template <int N, class T>
[[nodiscard]] constexpr bool precedes(const plane<N, T>& x, const plane<N, T>& y) {
    const int point = order_of(x.point, y.point);
    return (point != 0 ? point : order_of(x.normal, y.normal)) < 0;
}
// Walls, triangles.
template <class W>
requires requires(const W& w) { w.edge; }
[[nodiscard]] constexpr bool precedes(const W& x, const W& y) {
    int order = order_of(x.corner, y.corner);
    for (std::size_t i = 0; i < x.edge.size() && order == 0; ++i) {
        order = order_of(x.edge[i], y.edge[i]);
    }
    return order < 0;
}

// 0, 1, ... sorted; precedes(parts, i, j): whether i comes before j. Compiled once for all kinds of parts.
[[nodiscard, gnu::noinline]] inline records<int> sorted_indices(std::size_t n, const void* parts,
                                                                bool (*precedes)(const void* parts, int i, int j)) {
    records<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [=](int i, int j) { return precedes(parts, i, j); });
    return order;
}

// The indices of the parts in that order. Equal parts are ordered by their marks, if there are any; identical ones stay
// as they come.
template <class Part>
[[nodiscard]] records<int> canonical_order(std::span<const Part> pieces, std::span<const std::uint8_t> marks = {}) {
    struct marked {
        const Part* pieces;
        const std::uint8_t* marks; // or nullptr
    };
    const marked all{pieces.data(), marks.empty() ? nullptr : marks.data()};
    return sorted_indices(pieces.size(), &all, [](const void* parts, int i, int j) {
        const marked& m = *static_cast<const marked*>(parts);
        const Part &x = m.pieces[i], &y = m.pieces[j];
        if (precedes(x, y) || precedes(y, x)) {
            return precedes(x, y);
        }
        const int mark = m.marks == nullptr ? 0 : m.marks[i] - m.marks[j];
        return mark != 0 ? mark < 0 : i < j;
    });
}

} // namespace graze::inline v0_1::detail
