// Reads __float128.
#pragma once

#include "../reader.hpp"

#include <graze/number/adapter/float128.hpp>

namespace compare {

template <>
struct reader<__float128> {
    [[nodiscard]] static computed read(__float128 x, const true_value&) {
        return finiteq(x) != 0 ? computed(taken_apart(x)) : computed(not_finite{});
    }
};

} // namespace compare
