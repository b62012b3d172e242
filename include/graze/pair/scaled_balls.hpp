// Two balls in doubles, brought to a size at which their formulas neither over- nor underflow.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/exact/binary.hpp>
#include <graze/machine/environment.hpp>
#include <graze/machine/fence.hpp>
#include <graze/shape/ball.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// Lengths are 2^length and velocities 2^velocity times what they are in these balls.
template <int N>
struct scaled_balls {
    ball<N, double> a, b;
    int length = 0, velocity = 0;
    bool known = false;
};

// The largest of some numbers' orders of magnitude.
template <class... T>
[[nodiscard, gnu::always_inline]] inline std::uint64_t largest_order(const T&... x) noexcept {
    std::uint64_t largest = 0;
    ((largest = std::max(largest, order_of_magnitude(x))), ...);
    return largest;
}
template <int N>
[[nodiscard, gnu::always_inline]] inline std::uint64_t largest_order(const vec<N, double>& x,
                                                                     const vec<N, double>& y) noexcept {
    if constexpr (N == 2) {
        return largest_order(x[0], x[1], y[0], y[1]);
    } else {
        return largest_order(x[0], x[1], x[2], y[0], y[1], y[2]);
    }
}

// Whether lengths and velocities are of a size at which nothing needs to be scaled: the largest within 2^±100. Others
// may be smaller than that; bounds cover what they lose.
template <int N>
[[nodiscard, gnu::always_inline]] inline bool has_usual_range(const ball<N, double>& a,
                                                              const ball<N, double>& b) noexcept {
    const auto usual = [](std::uint64_t order) {
        return order - (std::uint64_t{1023 - 100} << 52) < std::uint64_t{200} << 52;
    };
    return usual(std::max(largest_order(a.position, b.position), largest_order(a.radius, b.radius))) &&
           usual(largest_order(a.velocity, b.velocity));
}

// The exponent by which numbers of at most this order are multiplied: the largest is then within [2^-52, 2).
[[nodiscard]] inline int scale_of(std::uint64_t order) noexcept {
    return std::clamp(1023 - static_cast<int>(order >> 52), -1022, 1023);
}

// By one power of two for all lengths and one for all velocities, chosen from the largest; of the others what is below
// 2^-1074 of that is lost. Not known when a number is not finite, all of a kind are zero, or where subnormals are read
// or written as zeros.
template <int N>
[[nodiscard, gnu::always_inline]] inline scaled_balls<N> scaled(const ball<N, double>& a,
                                                                const ball<N, double>& b) noexcept {
    scaled_balls<N> r;
    const std::uint64_t length = std::max(largest_order(a.position, b.position), largest_order(a.radius, b.radius));
    const std::uint64_t velocity = largest_order(a.velocity, b.velocity);
    constexpr std::uint64_t infinite = 0x7ff0000000000000U;
    if (!(std::max(length, velocity) < infinite && std::min(length, velocity) != 0 && keeps_subnormals())) {
        return r;
    }
    const int up = scale_of(length);
    const int faster = scale_of(velocity);
    const double by = power_of_two(up);
    const double speed = power_of_two(faster);
    const auto times = [](const vec<N, double>& x, double factor) __attribute__((always_inline)) {
        return make_vec<N>([&](int i) { return as_stored(as_stored(x[i]) * factor); });
    };
    r.a.position = times(a.position, by);
    r.b.position = times(b.position, by);
    r.a.velocity = times(a.velocity, speed);
    r.b.velocity = times(b.velocity, speed);
    r.a.radius = as_stored(as_stored(a.radius) * by);
    r.b.radius = as_stored(as_stored(b.radius) * by);
    r.length = -up;
    r.velocity = -faster;
    r.known = true;
    return r;
}

} // namespace graze::inline v0_1::detail
