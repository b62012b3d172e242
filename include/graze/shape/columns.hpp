// Many balls as a structure of arrays.
#pragma once

#include <array>
#include <cstddef>

namespace graze::inline v0_1 {

// Along axis k, ball i is at position[k][i] and flies at velocity[k][i]. Its radius is radius[i]; i < size. A
// non-owning view. Columns have no masses: no function that takes them needs any.
template <int N, class T = double>
struct columns {
    std::array<const T*, N> position;
    std::array<const T*, N> velocity;
    const T* radius;
    std::size_t size;

    // The balls from `first` on, at most `count` of them; none if there are not so many.
    [[nodiscard]] constexpr columns part(std::size_t first, std::size_t count) const noexcept {
        columns r = *this;
        first = first < size ? first : size;
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
