#include "../exact_access.hpp"
#include "../measure.hpp"
#include "types.hpp"

namespace compare {

template <>
struct converter<exact> {
    [[nodiscard]] static exact from(const exact_view& x) { return exact_access::behind(x); }
};

template <>
struct reader<exact> : exact_reader<exact> {
    [[nodiscard]] static fraction parts_of(const exact& x) { return exact_access::view(x).parts(); }
};

namespace types {

measurable of_cpp_rational() { return measurable_type<exact>("Boost", true); }

} // namespace types
} // namespace compare
