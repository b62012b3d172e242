// Inputs as integers in common units, one for lengths and one for velocities: from double, float, integers and
// rationals, without an error.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <vector>

namespace oracle {

template <int N>
struct point {
    std::array<mpz_class, static_cast<std::size_t>(N)> component;
    mpz_class& operator[](std::size_t i) { return component[i]; }
    const mpz_class& operator[](std::size_t i) const { return component[i]; }
};

template <int N>
mpz_class dot(const point<N>& x, const point<N>& y) {
    mpz_class sum = x[0] * y[0] + x[1] * y[1];
    if constexpr (N == 3) {
        sum += x[2] * y[2];
    }
    return sum;
}
template <int N>
point<N> operator-(const point<N>& x, const point<N>& y) {
    point<N> difference;
    for (std::size_t i = 0; i < N; ++i) {
        difference[i] = x[i] - y[i];
    }
    return difference;
}
template <int N>
point<N> operator+(const point<N>& x, const point<N>& y) {
    point<N> sum;
    for (std::size_t i = 0; i < N; ++i) {
        sum[i] = x[i] + y[i];
    }
    return sum;
}

// Numbers of one kind: collected first, then given out in the same order as integers; value = integer · unit.
template <class T>
class group;

template <std::floating_point T>
requires(sizeof(T) <= sizeof(double)) class group<T> {
  public:
    void collect(T x) {
        const double y = static_cast<double>(x);
        if (y == 0) {
            parts_.push_back({0, INT_MAX});
            return;
        }
        int exponent = 0;
        auto integer = static_cast<std::int64_t>(std::ldexp(std::frexp(y, &exponent), 53));
        const int zeros = std::countr_zero(static_cast<std::uint64_t>(integer));
        parts_.push_back({integer / (std::int64_t{1} << zeros), exponent - 53 + zeros});
        low_ = std::min(low_, parts_.back().exponent);
    }
    mpz_class next() {
        const part x = parts_[given_++];
        mpz_class z(static_cast<long>(x.integer));
        return x.integer == 0 ? z : mpz_class(z << static_cast<unsigned long>(x.exponent - low_));
    }
    mpq_class unit() const {
        if (low_ == INT_MAX) {
            return 1;
        }
        const mpz_class power = mpz_class(1) << static_cast<unsigned long>(std::abs(low_));
        return low_ >= 0 ? mpq_class(power) : mpq_class(1, power);
    }

  private:
    struct part {
        std::int64_t integer;
        int exponent;
    };
    std::vector<part> parts_;
    std::size_t given_ = 0;
    int low_ = INT_MAX;
};

template <std::integral T>
class group<T> {
  public:
    void collect(T x) { values_.push_back(static_cast<long>(x)); }
    mpz_class next() { return values_[given_++]; }
    mpq_class unit() const { return 1; }

  private:
    std::vector<long> values_;
    std::size_t given_ = 0;
};

template <>
class group<mpq_class> {
  public:
    void collect(const mpq_class& x) {
        values_.push_back(x);
        denominator_ = lcm(denominator_, x.get_den());
    }
    mpz_class next() {
        const mpq_class& x = values_[given_++];
        return x.get_num() * (denominator_ / x.get_den());
    }
    mpq_class unit() const { return mpq_class(1, denominator_); }

  private:
    std::vector<mpq_class> values_;
    std::size_t given_ = 0;
    mpz_class denominator_ = 1;
};

// A number as a group takes it: as it is, or as a rational.
template <class T>
auto input(const T& x) {
    if constexpr (std::is_arithmetic_v<T>) {
        return x;
    } else if constexpr (requires { x.value(); }) {
        return mpq_class(x.value());
    } else {
        return mpq_class(x);
    }
}
template <class T>
using input_type = decltype(input(std::declval<T>()));

template <class T>
struct groups {
    group<input_type<T>> lengths, velocities;

    // The unit of time.
    mpq_class time() const { return lengths.unit() / velocities.unit(); }
};

template <int N, class T, class V>
void collect(group<T>& g, const V& v) {
    for (int i = 0; i < N; ++i) {
        g.collect(input(v[i]));
    }
}
template <int N, class T>
point<N> next(group<T>& g) {
    point<N> p;
    for (auto& x : p.component) {
        x = g.next();
    }
    return p;
}

} // namespace oracle
