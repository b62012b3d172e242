// All whole coordinates between two corners.
#pragma once

#include <array>
#include <cstddef>

namespace graze::inline v0_1::detail {

// f(c) for each c with low <= c <= high along every axis, the first axis fastest.
template <class I, std::size_t N, class F>
[[gnu::always_inline]] constexpr inline void for_each_in_box(const std::array<I, N>& low, const std::array<I, N>& high,
                                                             F f) {
    for (std::size_t axis = 0; axis < N; ++axis) {
        if (low[axis] > high[axis]) {
            return;
        }
    }
    std::array<I, N> c = low;
    while (true) {
        f(c);
        std::size_t axis = 0;
        while (axis < N && c[axis] == high[axis]) {
            c[axis] = low[axis];
            ++axis;
        }
        if (axis == N) {
            return;
        }
        ++c[axis];
    }
}

} // namespace graze::inline v0_1::detail
