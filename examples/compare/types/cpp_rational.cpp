#include "../measure.hpp"
#include "types.hpp"

namespace compare {

template <>
struct reader<exact> {
    [[nodiscard]] static computed read(const exact& x, const true_value&) { return exact_real(x); }
};

namespace types {

measurable of_cpp_rational() { return measurable_type<exact>("Boost", true); }

} // namespace types
} // namespace compare
