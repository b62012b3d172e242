#include "../measure.hpp"
#include "core_errors.hpp"
#include "types.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <cmath>

namespace compare {

using interval_number = CGAL::Interval_nt<true>;

template <>
struct converter<interval_number> {
    [[nodiscard]] static interval_number from(const exact_view& x) { return {x.below(), x.above()}; }
};

template <>
struct reader<interval_number> {
    using undecided = CGAL::Uncertain_conversion_exception;
    static void read(const interval_number& x, const request& asked) {
        if (std::isfinite(x.inf()) && std::isfinite(x.sup())) {
            asked.to.interval(taken_apart(x.inf()), taken_apart(x.sup()));
        } else {
            asked.to.not_finite();
        }
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
