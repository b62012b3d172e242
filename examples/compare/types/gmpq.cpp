#include "../measure.hpp"
#include "core_errors.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <gmpxx.h>

namespace compare {

template <>
struct converter<CGAL::Gmpq> {
    [[nodiscard]] static CGAL::Gmpq from(const exact_view& x) {
        mpq_class result;
        set_rational(result.get_mpq_t(), x);
        return CGAL::Gmpq(result.get_mpq_t());
    }
};

template <>
struct reader<CGAL::Gmpq> : exact_reader<CGAL::Gmpq> {
    [[nodiscard]] static fraction parts_of(const CGAL::Gmpq& x) { return fraction_of(x.mpq()); }
};

namespace types {

measurable of_gmpq() { return measurable_type<CGAL::Gmpq>("CGAL", true, "GMP's mpq_t, counted references"); }

} // namespace types
} // namespace compare
