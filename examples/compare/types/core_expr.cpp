#include "../measure.hpp"
#include "../rounding.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <stdexcept>

namespace compare {

namespace {

CORE::Expr expression_of(const exact& x) {
    CORE::BigRat rational;
    set_rational(rational.get_mp(), x);
    return CORE::Expr(rational);
}

CORE::Expr expression_of(const exact_real& x) {
    return expression_of(x.p()) + expression_of(x.q()) * CORE::sqrt(expression_of(x.d()));
}

// A binary number within 2^-400 of x, relatively.
wide approximation_of(const CORE::Expr& x) {
    const CORE::BigFloat value = x.approx(400, CORE::extLong::getPosInfty()).BigFloatValue();
    CORE::BigInt significand = value.m();
    return ldexp(wide(integer_of(significand.get_mp())), value.exp() * 30); // CORE::BigFloat counts in 2^30
}

} // namespace

template <>
struct converter<CORE::Expr> {
    [[nodiscard]] static CORE::Expr from(const exact& x) { return expression_of(x); }
};

template <>
struct reader<CORE::Expr> {
    // No value where CORE gives none but an error (see core_errors.hpp).
    [[nodiscard]] static computed read(const CORE::Expr& x, const true_value& right) {
        try {
            if (x == expression_of(right.exactly())) {
                return exactly_right{};
            }
            return approximation_of(x);
        } catch (const std::runtime_error&) {
            return not_finite{};
        }
    }
    static void settle(const CORE::Expr& x) { static_cast<void>(x.doubleValue()); }
};

namespace types {

measurable of_core_expr() {
    return measurable_type<CORE::Expr>("CGAL", true,
                                       "an expression, as precise as a sign needs it; timed with times, positions "
                                       "and velocities read as doubles");
}

} // namespace types
} // namespace compare
