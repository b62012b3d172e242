// glm's vectors of two or three components.
#pragma once

#include <graze/linear/vector_access.hpp>

#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace graze::inline v0_1 {

template <glm::length_t N, class T, glm::qualifier Q>
requires(N == 2 || N == 3) struct vector_access<glm::vec<N, T, Q>> {
    static constexpr int dimension = N;
    using scalar = T;
    [[nodiscard]] static constexpr T element(const glm::vec<N, T, Q>& v, int i) { return v[i]; }
};

} // namespace graze::inline v0_1
