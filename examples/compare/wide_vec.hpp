// Vectors of wide numbers.
#pragma once

#include "wide.hpp"

#include <graze/linear/vec.hpp>

namespace compare {

template <int N>
using wide_vec = graze::vec<N, wide>;

template <int N>
[[nodiscard]] wide_vec<N> widened(const graze::vec<N, exact>& x) {
    return graze::make_vec<N>([&](int i) { return to_wide(x[i]); });
}

} // namespace compare
