#include "../measure.hpp"
#include "core_errors.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <stdexcept>

namespace compare {

namespace {

CORE::Expr expression_of(const exact_view& x) {
    CORE::BigRat rational;
    set_rational(rational.get_mp(), x);
    return CORE::Expr(rational);
}

CORE::Expr expression_of(const due_number& x) {
    return expression_of(x.p) + expression_of(x.q) * CORE::sqrt(expression_of(x.d));
}

// A binary number within a relative 2^-400 of x.
binary_number approximation_of(const CORE::Expr& x) {
    const CORE::BigFloat value = x.approx(400, CORE::extLong::getPosInfty()).BigFloatValue();
    CORE::BigInt significand = value.m();
    return {whole_of(significand.get_mp()), value.exp() * 30}; // CORE::BigFloat counts in 2^30
}

} // namespace

template <>
struct converter<CORE::Expr> {
    [[nodiscard]] static CORE::Expr from(const exact_view& x) { return expression_of(x); }
};

template <>
struct reader<CORE::Expr> {
    // Tells no value if CORE reports an error (see core_errors.hpp).
    static void read(const CORE::Expr& x, const request& asked) {
        try {
            if (x == expression_of(asked.due)) {
                asked.to.exactly_right();
            } else {
                asked.to.number(approximation_of(x));
            }
        } catch (const std::runtime_error&) {
            asked.to.not_finite();
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
