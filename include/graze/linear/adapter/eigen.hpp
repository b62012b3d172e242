// Eigen's vectors, rows or columns of two or three, and expressions of them.
#pragma once

#include <graze/linear/vector_access.hpp>

#include <Eigen/Core>

namespace graze::inline v0_1 {

template <class V>
requires std::derived_from<V, Eigen::MatrixBase<V>> &&(V::IsVectorAtCompileTime != 0) struct vector_access<V> {
    static constexpr int dimension = V::SizeAtCompileTime;
    using scalar = typename V::Scalar;
    [[nodiscard]] static scalar element(const V& v, int i) { return v.coeff(i); }
};

} // namespace graze::inline v0_1
