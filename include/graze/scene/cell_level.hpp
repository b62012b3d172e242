// The cells of one size in which points are.
#pragma once

#include <graze/linear/vec.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

[[nodiscard]] inline std::int64_t whole_below(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(std::clamp(x, -0x1p60, 0x1p60));
    return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

// power: which level this is. around: so many cells are a period, 0 where there is none. reach: the largest yet of its
// points. count: of points.
template <int N>
struct cell_level {
    using cell = std::array<std::int64_t, N>;

    int power = 0;
    vec<N, double> per_length{};
    cell around{};
    double reach = 0;
    std::size_t count = 0;

    // Cells of that width, or as much wider as it takes to have a whole number of them in a period.
    cell_level(int of, double width, const vec<N, double>& period) noexcept : power(of) {
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const bool circle = period[i] > 0;
            around[k] = circle ? std::max<std::int64_t>(1, whole_below(std::min(period[i] / width, 0x1p30))) : 0;
            per_length.component[i] = circle ? static_cast<double>(around[k]) / period[i] : 1 / width;
        }
    }

    // Monotonic in x, however its product is rounded.
    [[nodiscard]] std::int64_t along(double x, int axis) const noexcept { return whole_below(x * per_length[axis]); }
    // The same cell, by its coordinate in [0, around).
    [[nodiscard]] std::int64_t wrapped(std::int64_t coordinate, int axis) const noexcept {
        const std::int64_t n = around[static_cast<std::size_t>(axis)];
        if (n == 0) {
            return coordinate;
        }
        const std::int64_t rest = coordinate % n;
        return rest < 0 ? rest + n : rest;
    }
    // Cells side by side along the first axis have their lists side by side.
    [[nodiscard]] std::uint64_t key_of(const cell& c) const noexcept {
        std::uint64_t key = static_cast<std::uint64_t>(c[0]) + static_cast<std::uint64_t>(power) * 0xd6e8feb86659fd93U +
                            static_cast<std::uint64_t>(c[1]) * 0x9e3779b97f4a7c55U;
        if constexpr (N == 3) {
            key += static_cast<std::uint64_t>(c[2]) * 0xc2b2ae3d27d4eb4fU;
        }
        return key;
    }
};

} // namespace graze::inline v0_1::detail
