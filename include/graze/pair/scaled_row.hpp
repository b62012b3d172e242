// A pair's numbers in units of its own: one power of two multiplies all lengths and one all velocities.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/exact/binary.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// Numbers of a row, times 2^power: the largest one is then in [1, 2). `plain`, and exact, if the smallest is then not
// below 2^-900.
template <class T>
struct scaled_group {
    const T* first;
    int power = 0;
    bool plain = true;

    scaled_group(const T* row, std::size_t count) noexcept : first(row) {
        int highest = -5000;
        int lowest = 5000;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = static_cast<double>(row[i]);
            const binary b = split(x);
            if (b.significand != 0) {
                const auto size = static_cast<std::uint64_t>(b.significand < 0 ? -b.significand : b.significand);
                const int exponent = b.exponent + static_cast<int>(std::bit_width(size));
                highest = std::max(highest, exponent);
                lowest = std::min(lowest, exponent);
            }
        }
        power = highest == -5000 ? 0 : 1 - highest;
        plain = lowest + power > -900;
    }
    template <class I>
    [[nodiscard]] I get(std::size_t i) const noexcept {
        const int half = power / 2;
        return I(static_cast<double>(first[i]) * power_of_two(half) * power_of_two(power - half));
    }
};
template <class P, class T>
struct scaled_row {
    scaled_group<T> length, velocity;
    explicit scaled_row(const T* row) noexcept : length(row, P::lengths), velocity(row + P::lengths, P::velocities) {}
};

} // namespace graze::inline v0_1::detail
