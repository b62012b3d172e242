// Boost's MPFR numbers: conversion from exact values.
#pragma once

#include "../reader.hpp"
#include "gmp_exact.hpp"

#include <graze/number/adapter/mpfr.hpp>

namespace compare {

using mpfr_float_50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50>, boost::multiprecision::et_off>;

template <>
struct converter<mpfr_float_50> {
    [[nodiscard]] static mpfr_float_50 from(const exact_view& x) {
        mpq_t rational;
        mpq_init(rational);
        set_rational(rational, x);
        mpfr_float_50 result;
        mpfr_set_q(result.backend().data(), rational, MPFR_RNDN);
        mpq_clear(rational);
        return result;
    }
};

template <>
struct reader<mpfr_float_50> {
    static void read(const mpfr_float_50& x, const request& asked) {
        const mpfr_srcptr value = x.backend().data();
        if (mpfr_number_p(value) == 0) {
            return asked.to.not_finite();
        }
        if (mpfr_zero_p(value) != 0) {
            return asked.to.number({});
        }
        mpz_t significand;
        mpz_init(significand);
        const mpfr_exp_t exponent = mpfr_get_z_2exp(significand, value);
        asked.to.number({whole_of(significand), exponent});
        mpz_clear(significand);
    }
};

} // namespace compare
