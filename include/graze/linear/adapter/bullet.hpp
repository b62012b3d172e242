// Bullet's vectors of space, in its btScalar, which is float or, with BT_USE_DOUBLE_PRECISION, double.
#pragma once

#include <graze/linear/vector_access.hpp>

#include <LinearMath/btVector3.h>

namespace graze::inline v0_1 {

template <>
struct vector_access<btVector3> {
    static constexpr int dimension = 3;
    using scalar = btScalar;
    [[nodiscard]] static scalar element(const btVector3& v, int i) { return v.m_floats[i]; }
};

} // namespace graze::inline v0_1
