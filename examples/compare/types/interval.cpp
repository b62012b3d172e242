#include "../measure.hpp"
#include "../rounding.hpp"
#include "types.hpp"

#include <graze/number/adapter/cgal.hpp>

namespace compare {

using interval_number = CGAL::Interval_nt<true>;

template <>
struct converter<interval_number> {
    [[nodiscard]] static interval_number from(const exact& x) { return {double_below(x), double_above(x)}; }
};

template <>
struct reader<interval_number> {
    using undecided = CGAL::Uncertain_conversion_exception;
    [[nodiscard]] static computed read(const interval_number& x, const true_value&) {
        const bool finite = std::isfinite(x.inf()) && std::isfinite(x.sup());
        return finite ? computed(interval{wide_of(x.inf()), wide_of(x.sup())}) : computed(not_finite{});
    }
};

namespace types {

measurable of_interval() {
    measurable result = measurable_type<interval_number>(
        "CGAL", false, "two doubles around the value; its error is that of the farther one");
    result.information.is_interval = true;
    return result;
}

} // namespace types
} // namespace compare
