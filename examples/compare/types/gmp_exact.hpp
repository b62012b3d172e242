// Between GMP's numbers and the comparison's own.
#pragma once

#include "../exact_view.hpp"

#include <gmp.h>

#include <cstddef>

namespace compare {

[[nodiscard]] inline whole_number whole_of(mpz_srcptr x) {
    whole_number result;
    result.negative = mpz_sgn(x) < 0;
    result.digits.resize((mpz_sizeinbase(x, 2) + 31) / 32);
    std::size_t count = 0;
    mpz_export(result.digits.data(), &count, 1, sizeof(std::uint32_t), 0, 0, x);
    result.digits.resize(count);
    return result;
}

[[nodiscard]] inline fraction fraction_of(mpq_srcptr x) { return {whole_of(mpq_numref(x)), whole_of(mpq_denref(x))}; }

inline void set_integer(mpz_ptr to, const whole_number& x) {
    mpz_import(to, x.digits.size(), 1, sizeof(std::uint32_t), 0, 0, x.digits.data());
    if (x.negative) {
        mpz_neg(to, to);
    }
}

// Needs no reduction: a view's parts are in lowest terms.
inline void set_rational(mpq_ptr to, const exact_view& x) {
    const fraction parts = x.parts();
    set_integer(mpq_numref(to), parts.numerator);
    set_integer(mpq_denref(to), parts.denominator);
}

} // namespace compare
