// Scenes that repeat themselves along an axis.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/number/traits.hpp>
#include <graze/pair/image_shift.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <stdexcept>

namespace graze::inline v0_1 {

// Brings x into (-length/2, length/2], by the IEEE remainder of x by length > 0, exactly where T is a floating-point
// type or subtracts exactly. A half becomes the upper one and a zero +0, so that nothing depends on the period in which
// x was. Returns by how many lengths x was larger. Throws std::range_error if these are 2^30 or more.
template <class T>
constexpr std::int32_t bring_within(T& x, const T& length) {
    if constexpr (std::floating_point<T>) {
        if (x < length / 2 && x > -length / 2 && x != 0) [[likely]] { // a half is exact
            return 0;
        }
    }
    const double periods = static_cast<double>(x) / static_cast<double>(length);
    if (!(periods < 0x1p30 && periods > -0x1p30)) {
        throw std::range_error("a position is too many periods away");
    }
    T rest = x;
    std::int32_t count = 0;
    if constexpr (std::floating_point<T>) {
        if (!(rest <= length / 2 && rest >= -length / 2)) { // a half is exact
            rest = std::remainder(x, length);
            count = static_cast<std::int32_t>(std::nearbyint((x - rest) / length));
        }
    } else {
        count = static_cast<std::int32_t>(std::nearbyint(periods));
        rest = T(x - T(T(count) * length));
        while (length < T(rest + rest)) {
            rest = T(rest - length);
            ++count;
        }
        while (T(rest + rest) < T(-length)) {
            rest = T(rest + length);
            --count;
        }
    }
    if (!(T(-length) < T(rest + rest))) {
        rest = T(rest + length);
        --count;
    }
    x = graze::sign(rest) == 0 ? T(0) : rest;
    return count;
}
template <int N, class T>
constexpr std::array<std::int32_t, 3> bring_within(vec<N, T>& x, const vec<N, T>& period) {
    std::array<std::int32_t, 3> gone{};
#pragma GCC unroll 3
    for (int i = 0; i < N; ++i) {
        if (graze::sign(period[i]) > 0) {
            gone[static_cast<std::size_t>(i)] = bring_within(x.component[i], period[i]);
        }
    }
    return gone;
}

} // namespace graze::inline v0_1
