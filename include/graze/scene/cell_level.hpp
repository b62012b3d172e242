// The cells of one size that hold points.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/cell_lists.hpp>
#include <graze/scene/image_code.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

[[nodiscard]] inline std::int64_t whole_below(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(std::clamp(x, -0x1p60, 0x1p60));
    return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

// power: the number of the level. length: of a cell. around: how many cells make a period; without one, more than there
// can be. start: where the first cell of a period begins. reach: the largest so far of its points. count: the number of
// points. finer: those of levels far below this one, in its cells.
template <int N>
struct cell_level {
    using cell = std::array<std::int64_t, N>;
    static constexpr std::int64_t endless = std::int64_t{1} << 62;

    int power = 0;
    vec<N, double> length{}, per_length{}, start{};
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
            length.component[i] = 1 / per_length[i];
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

        // How many cells it has, if there are not more than `most_along` along any axis; else more than can be counted.
        [[nodiscard]] double cells() const noexcept {
            double all = 1;
            for (std::size_t k = 0; k < N; ++k) {
                const auto along = static_cast<double>(high[k] - low[k] + 1);
                all *= along > most_along ? 0x1p1000 : along;
            }
            return all;
        }
    };
    static constexpr int most_along = 8;
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
        std::uint64_t key = static_cast<std::uint64_t>(power) * per_power;
        for (int i = 0; i < N; ++i) {
            key += key_along(c[static_cast<std::size_t>(i)], i);
        }
        return key;
    }
    // f(from, image, key) for each cell of that box, of up to most_along cells along an axis, that comes as near to x
    // as `far`: the cell with that key holds that image of its points, and x is at `from` as seen from the points.
    //
    // `far` is at least an eighth of a cell, and by a thousandth more than points are away. Where a cell begins is
    // computed to 2^-50 of its distance from the first cell: up to 2^36 cells from there, to 2^-14 of a cell, which is
    // less than that thousandth. Farther away all cells are near.
    template <class F>
    void for_each(const box& within, const vec<N, double>& x, double far, const vec<N, double>& period, F f) const {
        std::array<steps, N> all;
        for (int i = 0; i < N; ++i) {
            all[static_cast<std::size_t>(i)] = steps_along(within, x[i], far, period[i], i);
        }
        vec<N, double> from;
        walk<N - 1>(all, from, 0, static_cast<std::uint64_t>(power) * per_power, far * far, f);
    }

  private:
    // The key is the sum of a multiple of the power and of these.
    static constexpr std::uint64_t per_power = 0xd6e8feb86659fd93U;
    [[nodiscard]] static std::uint64_t key_along(std::int64_t coordinate, int axis) noexcept {
        constexpr std::array<std::uint64_t, 3> factors = {1, 0x9e3779b97f4a7c55U, 0xc2b2ae3d27d4eb4fU};
        return static_cast<std::uint64_t>(coordinate) * factors[static_cast<std::size_t>(axis)];
    }
    // The period in which that cell is.
    [[nodiscard]] std::int32_t period_of(std::int64_t coordinate, int axis) const noexcept {
        const std::int64_t n = around[static_cast<std::size_t>(axis)];
        return n == endless ? 0 : static_cast<std::int32_t>((coordinate - (coordinate < 0 ? n - 1 : 0)) / n);
    }
    // The cells of a box along one axis. square: of the distance between x and those cells, along this axis.
    struct step {
        double from, square;
        std::uint64_t key;
        image_code image;
    };
    struct steps {
        std::array<step, most_along> all;
        std::size_t count = 0;
    };
    [[nodiscard]] steps steps_along(const box& within, double x, double far, double period, int axis) const noexcept {
        const auto k = static_cast<std::size_t>(axis);
        steps found;
        std::int32_t image = period_of(within.low[k], axis);
        std::int64_t at = within.low[k] - (image != 0 ? image * around[k] : 0);
        const double place = (x - start[axis]) * per_length[axis];
        const double unit = place < 0x1p36 && place > -0x1p36 ? length[axis] : 0;
        double ahead = static_cast<double>(within.low[k]) - place; // of x, in cells
        for (std::int64_t n = within.low[k]; n <= within.high[k]; ++n, ahead += 1) {
            const double apart = std::max({ahead, -1 - ahead, 0.0}) * unit;
            if (apart <= far) {
                found.all[found.count++] = {x - image * period, apart * apart, key_along(at, axis),
                                            coded_along(image, k)};
            }
            if (++at == around[k]) {
                at = 0;
                ++image;
            }
        }
        return found;
    }
    // Along this axis and those before, the cells whose squared distance is not above `left`.
    template <int Axis, class F>
    [[gnu::always_inline]] static void walk(const std::array<steps, N>& all, vec<N, double>& from, image_code image,
                                            std::uint64_t key, double left, F& f) {
        const steps& along = all[static_cast<std::size_t>(Axis)];
        for (std::size_t i = 0; i < along.count; ++i) {
            const step& s = along.all[i];
            if (const double rest = left - s.square; !(rest < 0)) {
                from.component[Axis] = s.from;
                if constexpr (Axis == 0) {
                    f(from, image + s.image, key + s.key);
                } else {
                    walk<Axis - 1>(all, from, image + s.image, key + s.key, rest, f);
                }
            }
        }
    }
};

} // namespace graze::inline v0_1::detail
