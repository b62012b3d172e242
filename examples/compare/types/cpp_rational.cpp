#include "../measure.hpp"
#include "types.hpp"

namespace compare {

template <>
struct reader<exact> : exact_reader<exact> {
    [[nodiscard]] static exact value_of(const exact& x) { return x; }
};

namespace types {

measurable of_cpp_rational() { return measurable_type<exact>("Boost", true); }

} // namespace types
} // namespace compare
