#include "../measure.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/gmp.hpp>

namespace compare {

using mpq_rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

template <>
struct converter<mpq_rational> {
    [[nodiscard]] static mpq_rational from(const exact_view& x) {
        mpq_rational result;
        set_rational(result.backend().data(), x);
        return result;
    }
};

template <>
struct reader<mpq_rational> : exact_reader<mpq_rational> {
    [[nodiscard]] static fraction parts_of(const mpq_rational& x) { return fraction_of(x.backend().data()); }
};

namespace types {

measurable of_mpq_rational() { return measurable_type<mpq_rational>("Boost on GMP", true); }

} // namespace types
} // namespace compare
