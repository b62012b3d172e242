// The place of an image, in a space that repeats itself along an axis.
#pragma once

#include <graze/linear/vec.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1 {

// Where an image is: this many whole periods from the thing itself, along each axis.
template <int N, class T>
struct image_shift {
    std::array<std::int32_t, 3> periods;
    vec<N, T> period;

    // In T's arithmetic.
    [[nodiscard]] constexpr vec<N, T> distance() const {
        return make_vec<N>([&](int i) { return T(T(periods[static_cast<std::size_t>(i)]) * period[i]); });
    }
};

} // namespace graze::inline v0_1
