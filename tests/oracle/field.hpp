// Arithmetic of surds that share a radicand.
#pragma once

#include "surd.hpp"

#include <algorithm>
#include <stdexcept>

namespace oracle {

// The same value with fewer common factors: for small numbers only powers of two, which come from the inputs. A
// greatest common divisor takes longer than the few products that it would shorten.
inline surd reduced(surd x) {
    if (x.q == 0) {
        x.d = 0;
    }
    if (mpz_sizeinbase(x.r.get_mpz_t(), 2) > 3000) {
        const mpz_class common = gcd(gcd(x.p, x.q), x.r);
        return {x.p / common, x.q / common, x.d, x.r / common};
    }
    const mp_bitcnt_t twos =
        std::min({mpz_scan1(x.p.get_mpz_t(), 0), mpz_scan1(x.q.get_mpz_t(), 0), mpz_scan1(x.r.get_mpz_t(), 0)});
    if (twos != 0) {
        x.p >>= twos;
        x.q >>= twos;
        x.r >>= twos;
    }
    return x;
}

inline const mpz_class& shared_radicand(const surd& x, const surd& y) {
    if (x.q != 0 && y.q != 0 && x.d != y.d) {
        throw std::logic_error("oracle: surds over different roots");
    }
    return x.q != 0 ? x.d : y.d;
}

inline surd operator+(const surd& x, const surd& y) {
    const mpz_class& d = shared_radicand(x, y);
    const mp_bitcnt_t twos_x = mpz_scan1(x.r.get_mpz_t(), 0), twos_y = mpz_scan1(y.r.get_mpz_t(), 0);
    if (mpz_class(x.r >> twos_x) == mpz_class(y.r >> twos_y)) { // the denominators differ by a power of two
        const mp_bitcnt_t up_x = twos_y > twos_x ? twos_y - twos_x : 0, up_y = twos_x > twos_y ? twos_x - twos_y : 0;
        return reduced({(x.p << up_x) + (y.p << up_y), (x.q << up_x) + (y.q << up_y), d, x.r << up_x});
    }
    return reduced({x.p * y.r + y.p * x.r, x.q * y.r + y.q * x.r, d, x.r * y.r});
}
inline surd operator-(const surd& x) { return {-x.p, -x.q, x.d, x.r}; }
inline surd operator-(const surd& x, const surd& y) { return x + -y; }
inline surd operator*(const surd& x, const surd& y) {
    const mpz_class& d = shared_radicand(x, y);
    return reduced({x.p * y.p + x.q * y.q * d, x.p * y.q + x.q * y.p, d, x.r * y.r});
}

// x/y for a rational y that is not 0.
inline surd operator/(const surd& x, const mpq_class& y) { return x * rational(1 / y); }

// √x of a rational x >= 0.
inline surd square_root(const mpq_class& x) { return {0, 1, x.get_num() * x.get_den(), x.get_den()}; }

// The value of a surd that is rational, possibly as p + q√d with a rational √d.
inline mpq_class rational_value(const surd& x) {
    if (x.q == 0) {
        mpq_class value(x.p, x.r);
        value.canonicalize();
        return value;
    }
    mpq_class value(x.p + x.q * sqrt(x.d), x.r);
    value.canonicalize();
    if (compare(x, value) != 0) {
        throw std::logic_error("oracle: not rational");
    }
    return value;
}

template <int N>
struct surd_vector {
    surd component[N];
    surd& operator[](int i) { return component[i]; }
    const surd& operator[](int i) const { return component[i]; }
};

template <int N>
surd_vector<N> operator+(const surd_vector<N>& x, const surd_vector<N>& y) {
    surd_vector<N> sum;
    for (int i = 0; i < N; ++i) {
        sum[i] = x[i] + y[i];
    }
    return sum;
}
template <int N>
surd_vector<N> operator*(const surd& s, const surd_vector<N>& x) {
    surd_vector<N> scaled;
    for (int i = 0; i < N; ++i) {
        scaled[i] = s * x[i];
    }
    return scaled;
}
template <int N>
surd_vector<N> operator-(const surd_vector<N>& x, const surd_vector<N>& y) {
    return x + rational(-1) * y;
}
template <int N>
surd dot(const surd_vector<N>& x, const surd_vector<N>& y) {
    surd sum = x[0] * y[0] + x[1] * y[1];
    if constexpr (N == 3) {
        sum = sum + x[2] * y[2];
    }
    return sum;
}

} // namespace oracle
