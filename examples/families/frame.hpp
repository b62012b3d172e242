// Vectors of integers, and orthogonal frames of them, in which exact tangents and contacts are built.
#pragma once

#include "random.hpp"

#include <array>
#include <cstdint>

namespace families {

template <int N>
using integers = std::array<std::int64_t, N>;

template <int N>
[[nodiscard]] constexpr integers<N> times(std::int64_t s, integers<N> x) {
    for (std::int64_t& component : x) {
        component *= s;
    }
    return x;
}

template <int N>
[[nodiscard]] constexpr integers<N> sum(integers<N> x, const integers<N>& y) {
    for (std::size_t i = 0; i < N; ++i) {
        x[i] += y[i];
    }
    return x;
}

template <int N>
[[nodiscard]] constexpr std::int64_t dot(const integers<N>& x, const integers<N>& y) {
    std::int64_t result = 0;
    for (std::size_t i = 0; i < N; ++i) {
        result += x[i] * y[i];
    }
    return result;
}

template <int N>
[[nodiscard]] constexpr integers<N> random_vector(random& r, int bits) {
    integers<N> x{};
    for (std::int64_t& component : x) {
        component = r.signed_bits(bits);
    }
    return x;
}

// Axes that are perpendicular to each other, of the same integer length (at most 2^12).
template <int N>
struct frame {
    std::array<integers<N>, N> axis;
    std::int64_t length;
};

// Made from the square of a random complex number or from a random quaternion (Euler's and Rodrigues' parameters),
// whose norm is odd so that no axis is even.
template <int N>
[[nodiscard]] constexpr frame<N> random_frame(random& r) {
    if constexpr (N == 2) {
        const std::int64_t x = r.in(1, 45), y = r.either_sign(2 * r.in(1, 19) - (x + 1) % 2);
        const std::int64_t real = x * x - y * y, imaginary = 2 * x * y;
        return {{{{real, imaginary}, {-imaginary, real}}}, x * x + y * y};
    } else {
        const std::int64_t x = r.signed_bits(5), y = r.signed_bits(5), z = r.signed_bits(5);
        const std::int64_t w = 2 * r.in(1, 15) + (x + y + z + 1) % 2;
        return {{{{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
                  {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
                  {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}},
                w * w + x * x + y * y + z * z};
    }
}

// A direction perpendicular to axis[0], and `weight`, which bounds its length in units of the frame's: weight/√2 <=
// |vector|/length <= weight.
template <int N>
struct cross_direction {
    integers<N> vector; // components below 2^19
    std::int64_t weight;
};

template <int N>
[[nodiscard]] constexpr cross_direction<N> random_cross_direction(random& r, const frame<N>& f) {
    if constexpr (N == 2) {
        return {times<2>(r.either_sign(1), f.axis[1]), 1};
    } else {
        const std::int64_t p = r.either_sign(r.in(1, 63)), q = r.signed_bits(6);
        return {sum<3>(times<3>(p, f.axis[1]), times<3>(q, f.axis[2])), (p < 0 ? -p : p) + (q < 0 ? -q : q)};
    }
}

} // namespace families
