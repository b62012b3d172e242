// Many balls as a structure of arrays.
#pragma once

#include <array>
#include <cstddef>

namespace graze::inline v0_1 {

// Ball i is at position[k][i], flies at velocity[k][i] along axis k, and has the radius radius[i]; i < size. Nothing is
// owned. Columns have no masses: nothing that is asked of them needs any.
template <int N, class T = double>
struct columns {
    std::array<const T*, N> position;
    std::array<const T*, N> velocity;
    const T* radius;
    std::size_t size;

    // The balls from `first` on, at most `count` of them.
    [[nodiscard]] constexpr columns part(std::size_t first, std::size_t count) const noexcept {
        columns r = *this;
        for (std::size_t k = 0; k < N; ++k) {
            r.position[k] += first;
            r.velocity[k] += first;
        }
        r.radius += first;
        r.size = count < size - first ? count : size - first;
        return r;
    }
};

} // namespace graze::inline v0_1
