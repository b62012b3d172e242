#include "../measure.hpp"
#include "core_errors.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <CGAL/Exact_rational.h>

namespace compare {

using lazy_exact = CGAL::Lazy_exact_nt<CGAL::Exact_rational>;

template <>
struct converter<lazy_exact> {
    [[nodiscard]] static lazy_exact from(const exact_view& x) {
        CGAL::Exact_rational result;
        set_rational(result.backend().data(), x);
        return lazy_exact(result);
    }
};

template <>
struct reader<lazy_exact> : exact_reader<lazy_exact> {
    [[nodiscard]] static fraction parts_of(const lazy_exact& x) { return fraction_of(x.exact().backend().data()); }
    static void settle(const lazy_exact& x) { static_cast<void>(CGAL::to_double(x)); }
};

namespace types {

measurable of_lazy_exact() {
    return measurable_type<lazy_exact>("CGAL", true,
                                       "intervals, exact when a sign needs it; timed with times, positions and "
                                       "velocities read as doubles");
}

measurable of_exact_rational() {
    measurable result;
    result.information.name = "CGAL::Exact_rational";
    result.information.library = "CGAL";
    result.information.is_exact = true;
    result.information.bytes = sizeof(CGAL::Exact_rational);
    result.information.real_bytes = 3 * sizeof(CGAL::Exact_rational);
    result.information.uses_heap = true;
    result.information.alias_of = "mpq_rational";
    return result;
}

} // namespace types
} // namespace compare
