// Between GMP's rationals and the comparison's own.
#pragma once

#include "../rounding.hpp"

#include <gmp.h>

#include <cstddef>
#include <string>
#include <vector>

namespace compare {

[[nodiscard]] inline exact_integer integer_of(mpz_srcptr x) {
    std::vector<unsigned char> bytes((mpz_sizeinbase(x, 2) + 7) / 8);
    std::size_t count = 0;
    mpz_export(bytes.data(), &count, 1, 1, 1, 0, x);
    bytes.resize(count);
    exact_integer result = 0;
    if (!bytes.empty()) {
        import_bits(result, bytes.begin(), bytes.end());
    }
    return mpz_sgn(x) < 0 ? exact_integer(-result) : result;
}

[[nodiscard]] inline exact rational_of(mpq_srcptr x) {
    return exact(integer_of(mpq_numref(x)), integer_of(mpq_denref(x)));
}

inline void set_integer(mpz_ptr to, const exact_integer& x) {
    std::vector<unsigned char> bytes;
    export_bits(exact_integer(abs(x)), std::back_inserter(bytes), 8);
    mpz_import(to, bytes.size(), 1, 1, 1, 0, bytes.data());
    if (x.sign() < 0) {
        mpz_neg(to, to);
    }
}

inline void set_rational(mpq_ptr to, const exact& x) {
    set_integer(mpq_numref(to), exact_integer(numerator(x)));
    set_integer(mpq_denref(to), exact_integer(denominator(x)));
    mpq_canonicalize(to);
}

} // namespace compare
