// Integers for tests: limbs of zeros and ones, borders of limbs, neighbours of powers of two; and the same in GMP.
#pragma once

#include "../property.hpp"

#include <gmpxx.h>

#include <bit>
#include <cstdint>
#include <initializer_list>

namespace wide {

inline mpz_class power(int bits) { return mpz_class(1) << static_cast<unsigned long>(bits); }

inline mpz_class from_unsigned(std::uint64_t x) {
    return (mpz_class(static_cast<unsigned long>(x >> 32)) << 32) + static_cast<unsigned long>(x & 0xffffffffU);
}
inline mpz_class from_signed(std::int64_t x) {
    return from_unsigned(static_cast<std::uint64_t>(x)) - (x < 0 ? power(64) : mpz_class(0));
}
// x modulo 2^64.
inline std::uint64_t low_word(const mpz_class& x) {
    mpz_class r;
    mpz_fdiv_r_2exp(r.get_mpz_t(), x.get_mpz_t(), 64);
    const mpz_class high = r >> 32;
    return static_cast<std::uint64_t>(high.get_ui()) << 32 | (r.get_ui() & 0xffffffffU);
}

inline std::uint64_t any_word() {
    switch (property::in_range(0, 5)) {
    case 0:
        return 0;
    case 1:
        return ~std::uint64_t{0};
    case 2:
        return std::uint64_t{1} << property::in_range(0, 64);
    case 3:
        return (std::uint64_t{1} << property::in_range(0, 64)) - 1;
    default:
        return property::any<std::uint64_t>();
    }
}

// |x| < 2^bits, often at the ends of that range and near powers of two.
inline mpz_class any(int bits) {
    mpz_class x;
    switch (property::in_range(0, 4)) {
    case 0:
        x = power(bits) - 1;
        break;
    case 1:
        x = power(property::in_range(0, bits)) + property::in_range(-1, 2);
        break;
    default:
        for (int i = 0; i < bits; i += 64) {
            x = (x << 64) + from_unsigned(any_word());
        }
    }
    x %= power(bits);
    return property::any<bool>() ? mpz_class(-x) : x;
}

template <class X>
mpz_class value(const X& x) {
    mpz_class sum = 0;
    if constexpr (requires { x.is_negated(); }) {
        for (int i = 0; i < x.count(); ++i) {
            sum += from_signed(x.digit(i)) * power(64 * (x.low() + i));
        }
        sum = x.is_negated() ? mpz_class(-sum) : sum;
    } else if constexpr (requires { x.count(); }) {
        for (int i = 0; i < x.count(); ++i) {
            sum += from_signed(x.digit(i)) * power(64 * x.position(i));
        }
    } else {
        for (int i = 0; i < X::limbs; ++i) {
            sum += from_unsigned(x.limb(i)) * power(64 * i);
        }
        sum -= x.is_negative() ? power(64 * X::limbs) : mpz_class(0);
    }
    return sum;
}

} // namespace wide
