// Exact real numbers (p + q√d)/r in GMP integers, and their order. This and the rest of tests/oracle use nothing of
// graze except the aggregates of shapes.
#pragma once

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace oracle {

// (p + q√d)/r with d >= 0 and r > 0.
struct surd {
    mpz_class p = 0, q = 0, d = 0, r = 1;
};

inline surd rational(const mpq_class& x) { return {x.get_num(), 0, 0, x.get_den()}; }

// The sign of p + q√d, d >= 0.
inline int sign_of(const mpz_class& p, const mpz_class& q, const mpz_class& d) {
    const int sp = sgn(p);
    const int sq = sgn(q) * sgn(d);
    if (sp * sq >= 0) {
        return sp != 0 ? sp : sq;
    }
    return sp * cmp(mpz_class(p * p), mpz_class(q * q * d));
}

// The sign of p + a√d + b√e, d and e >= 0.
inline int sign_of(const mpz_class& p, const mpz_class& a, const mpz_class& d, const mpz_class& b, const mpz_class& e) {
    const mpz_class x = a * a * d;
    const mpz_class y = b * b * e;
    const int sa = sgn(a) * sgn(d);
    const int sb = sgn(b) * sgn(e);
    const int roots = sa * sb >= 0 ? (sa != 0 ? sa : sb) : sa * cmp(x, y); // of a√d + b√e
    const int sp = sgn(p);
    if (sp * roots >= 0) {
        return sp != 0 ? sp : roots;
    }
    return sp * sign_of(mpz_class(p * p - x - y), mpz_class(-2 * a * b), mpz_class(d * e)); // p² against (a√d + b√e)²
}

inline int sign_of(const surd& x) { return sign_of(x.p, x.q, x.d); }

// -1, 0, +1 for x < y, x = y, x > y.
inline int compare(const surd& x, const surd& y) {
    const int s = sign_of(mpz_class(x.p * y.r - y.p * x.r), mpz_class(x.q * y.r), x.d, mpz_class(-y.q * x.r), y.d);
    return s < 0 ? -1 : s > 0 ? 1 : 0;
}
inline int compare(const surd& x, const mpq_class& y) { return compare(x, rational(y)); }

// A rational within 2^-bits of x, relative to the greater of |x| and 2^-1100.
inline mpq_class approximate(const surd& x, unsigned long bits = 80) {
    for (unsigned long k = bits;; k *= 2) {
        const mpz_class scaled = x.d << 2 * k;
        const mpz_class root = sqrt(scaled); // floor(√d 2^k)
        const mpz_class sum = (x.p << k) + x.q * root;
        const mpz_class error = abs(x.q); // |sum - true| < |q|
        if (error == 0 || abs(sum) >= error << bits ||
            (error << (bits + 1100)) <= x.r << k) { // relative to x, or absolute if x is nearly zero
            mpq_class value(sum, x.r << k);
            value.canonicalize();
            return value;
        }
    }
}

// x rounded to the nearest double, ties to even. It overflows from the middle beyond the largest double on.
inline double nearest_double(const surd& x) {
    if (sign_of(x) == 0) {
        return 0.0;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto exact = [](double y) {
        if (std::isinf(y)) { // it stands for the next power of two
            mpq_class power(mpz_class(1) << 1024);
            return y < 0 ? mpq_class(-power) : power;
        }
        return mpq_class(y);
    };
    const auto even = [](double y) { return (std::bit_cast<std::uint64_t>(y) & 1) == 0; };
    double y = approximate(x).get_d();
    for (;;) {
        const double up = std::nextafter(y, infinity);
        const double down = std::nextafter(y, -infinity);
        const int above = compare(x, mpq_class((exact(y) + exact(up)) / 2));
        const int below = compare(x, mpq_class((exact(y) + exact(down)) / 2));
        if (y != infinity && (above > 0 || (above == 0 && !even(y)))) {
            y = up;
        } else if (y != -infinity && (below < 0 || (below == 0 && !even(y)))) {
            y = down;
        } else {
            return y;
        }
    }
}

} // namespace oracle
