#include "../measure.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/gmp.hpp>

namespace compare {

template <>
struct converter<graze::gmp_rational> {
    [[nodiscard]] static graze::gmp_rational from(const exact& x) {
        mpq_class result;
        set_rational(result.get_mpq_t(), x);
        return graze::gmp_rational(std::move(result));
    }
};

template <>
struct reader<graze::gmp_rational> : exact_reader<graze::gmp_rational> {
    [[nodiscard]] static exact value_of(const graze::gmp_rational& x) { return rational_of(x.value().get_mpq_t()); }
};

namespace types {

measurable of_mpq_class() {
    return measurable_type<graze::gmp_rational>("GMP", true, "in a wrapper whose operators return values");
}

} // namespace types
} // namespace compare
