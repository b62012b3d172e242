#include "../measure.hpp"
#include "gmp_exact.hpp"
#include "types.hpp"

#include <graze/number/adapter/gmp.hpp>

namespace compare {

template <>
struct converter<graze::gmp_rational> {
    [[nodiscard]] static graze::gmp_rational from(const exact_view& x) {
        mpq_class result;
        set_rational(result.get_mpq_t(), x);
        return graze::gmp_rational(std::move(result));
    }
};

template <>
struct reader<graze::gmp_rational> : exact_reader<graze::gmp_rational> {
    [[nodiscard]] static fraction parts_of(const graze::gmp_rational& x) { return fraction_of(x.value().get_mpq_t()); }
};

namespace types {

measurable of_mpq_class() {
    return measurable_type<graze::gmp_rational>("GMP", true, "in a wrapper whose operators return values");
}

} // namespace types
} // namespace compare
