// Where something stands, in doubles.
#pragma once

#include <graze/formula/wall_features.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace graze::inline v0_1::detail {

// It is in a box, and in the plane through `point` with the normal n. Numbers are within 2^-46 of the true ones, those
// of a box relative to the largest along their axis. A plane's box is all space; so is that of a wall without a certain
// plane.
template <int N>
struct standing_extent {
    vec<N, double> low, high, point, n;

    static constexpr double endless = std::numeric_limits<double>::max();
    [[nodiscard]] constexpr bool is_bounded() const noexcept { return high[0] < endless; }
};

template <int N>
[[nodiscard]] standing_extent<N> endless_extent(const vec<N, double>& point, const vec<N, double>& n) {
    constexpr double far = standing_extent<N>::endless;
    return {make_vec<N>([](int) { return -far; }), make_vec<N>([](int) { return far; }), point, n};
}

// For a wall or a triangle, each number of which is within 2^-50 of the true one, relatively. The normal of edges that
// are nearly parallel cancels: each of its components is right to 2^-47 |e||f|.
template <int N>
[[nodiscard]] standing_extent<N> extent_of(const vec<N, double>& corner,
                                           const std::array<vec<N, double>, N - 1>& edge) {
    const vec<N, double> n = face_normal(edge);
    double largest = 1;
    for (const auto& e : edge) {
        largest *= graze::squared_norm(e);
    }
    if (!(graze::squared_norm(n) > 0x1p-60 * largest && largest < standing_extent<N>::endless)) {
        return endless_extent(corner, vec<N, double>{});
    }
    standing_extent<N> x{corner, corner, corner, n};
    for (const auto& e : edge) {
        for (int i = 0; i < N; ++i) {
            x.low.component[i] += std::min(e[i], 0.0);
            x.high.component[i] += std::max(e[i], 0.0);
        }
    }
    return x;
}

} // namespace graze::inline v0_1::detail
