#include "../measure.hpp"
#include "types.hpp"

#include <graze/number/float128.hpp>

namespace compare {

template <>
struct reader<__float128> {
    [[nodiscard]] static computed read(__float128 x, const true_value&) {
        return finiteq(x) != 0 ? computed(taken_apart(x)) : computed(not_finite{});
    }
};

namespace types {

measurable of_float128() { return measurable_type<__float128>("libquadmath"); }

} // namespace types
} // namespace compare
