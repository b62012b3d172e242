#include "../measure.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <boost/multiprecision/gmp.hpp>

namespace compare {

using mpq_rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

template <>
struct converter<mpq_rational> {
    [[nodiscard]] static mpq_rational from(const exact& x) {
        mpq_rational result;
        set_rational(result.backend().data(), x);
        return result;
    }
};

template <>
struct reader<mpq_rational> : exact_reader<mpq_rational> {
    [[nodiscard]] static exact value_of(const mpq_rational& x) { return rational_of(x.backend().data()); }
};

namespace types {

measurable of_mpq_rational() { return measurable_type<mpq_rational>("Boost on GMP", true); }

} // namespace types
} // namespace compare
