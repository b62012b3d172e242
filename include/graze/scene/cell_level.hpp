// The cells of one size that hold points.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/cell_lists.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

[[nodiscard]] inline std::int64_t whole_below(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(std::clamp(x, -0x1p60, 0x1p60));
    return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

// power: the number of the level. around: how many cells make a period; without one, more than there can be. start:
// where the first cell of a period begins. reach: the largest so far of its points. count: the number of points. finer:
// those of levels far below this one, in its cells.
template <int N>
struct cell_level {
    using cell = std::array<std::int64_t, N>;
    static constexpr std::int64_t endless = std::int64_t{1} << 62;

    int power = 0;
    vec<N, double> per_length{}, start{};
    cell around{};
    double reach = 0;
    std::size_t count = 0;
    cell_lists finer;

    // Cells of that width, or as much wider as it takes to have a whole number of them in a period.
    cell_level(int of, double width, const vec<N, double>& period) noexcept : power(of) {
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const bool circle = period[i] > 0;
            around[k] = circle ? std::max<std::int64_t>(1, whole_below(std::min(period[i] / width, 0x1p30))) : endless;
            per_length.component[i] = circle ? static_cast<double>(around[k]) / period[i] : 1 / width;
            start.component[i] = -period[i] / 2;
        }
    }

    // Monotonic in x, however it is rounded.
    [[nodiscard]] std::int64_t along(double x, int axis) const noexcept {
        return whole_below((x - start[axis]) * per_length[axis]);
    }
    // The corners of the cells that come as near to x as `far` along every axis.
    struct box {
        cell low, high;
    };
    [[nodiscard]] box cells_within(const vec<N, double>& x, double far) const noexcept {
        box b;
        for (int i = 0; i < N; ++i) {
            b.low[static_cast<std::size_t>(i)] = along(x[i] - far, i);
            b.high[static_cast<std::size_t>(i)] = along(x[i] + far, i);
        }
        return b;
    }
    // For a point within half a period of 0, but for rounding.
    [[nodiscard]] std::int64_t along_inside(double x, int axis) const noexcept {
        const std::int64_t n = around[static_cast<std::size_t>(axis)];
        return n == endless ? along(x, axis) : std::clamp<std::int64_t>(along(x, axis), 0, n - 1);
    }
    // Of the cell in which a point is.
    [[nodiscard]] std::uint64_t key_at(const vec<N, double>& x) const noexcept {
        cell c;
        for (int i = 0; i < N; ++i) {
            c[static_cast<std::size_t>(i)] = along_inside(x[i], i);
        }
        return key_of(c);
    }
    // Cells side by side along the first axis have their lists side by side.
    [[nodiscard]] std::uint64_t key_of(const cell& c) const noexcept {
        std::uint64_t key = first_key();
        for (int i = 0; i < N; ++i) {
            key += key_along(c[static_cast<std::size_t>(i)], i);
        }
        return key;
    }
    // f(from, image, key) for each cell in the box: the cell with that key holds that image of its points, and x is at
    // `from` as seen from the points.
    template <class F>
    void for_each(const cell& low, const cell& high, const vec<N, double>& x, const vec<N, double>& period, F f) const {
        walk<N - 1>(low, high, x, period, {}, first_key(), f);
    }

  private:
    // The key is the sum of these.
    [[nodiscard]] std::uint64_t first_key() const noexcept {
        return static_cast<std::uint64_t>(power) * 0xd6e8feb86659fd93U;
    }
    [[nodiscard]] static std::uint64_t key_along(std::int64_t coordinate, int axis) noexcept {
        constexpr std::array<std::uint64_t, 3> factors = {1, 0x9e3779b97f4a7c55U, 0xc2b2ae3d27d4eb4fU};
        return static_cast<std::uint64_t>(coordinate) * factors[static_cast<std::size_t>(axis)];
    }
    // The period in which that cell is.
    [[nodiscard]] std::int32_t period_of(std::int64_t coordinate, int axis) const noexcept {
        const std::int64_t n = around[static_cast<std::size_t>(axis)];
        return n == endless ? 0 : static_cast<std::int32_t>((coordinate - (coordinate < 0 ? n - 1 : 0)) / n);
    }
    // Along this axis and those before.
    template <int Axis, class F>
    [[gnu::always_inline]] void walk(const cell& low, const cell& high, vec<N, double> from,
                                     const vec<N, double>& period, whole_periods image, std::uint64_t key, F& f) const {
        constexpr auto k = static_cast<std::size_t>(Axis);
        const double x = from[Axis];
        image[k] = period_of(low[k], Axis);
        std::int64_t at = low[k] - (image[k] != 0 ? image[k] * around[k] : 0);
        from.component[Axis] = x - image[k] * period[Axis];
        for (std::int64_t left = high[k] - low[k]; left >= 0; --left) {
            const std::uint64_t there = key + key_along(at, Axis);
            if constexpr (Axis == 0) {
                f(from, image, there);
            } else {
                walk<Axis - 1>(low, high, from, period, image, there, f);
            }
            if (++at == around[k]) {
                at = 0;
                from.component[Axis] = x - ++image[k] * period[Axis];
            }
        }
    }
};

} // namespace graze::inline v0_1::detail
