// The oracle's own arithmetic, compared with MPFR at 4000 bits.
#include "../property.hpp"
#include "encounter.hpp"
#include "field.hpp"

#include <doctest/doctest.h>

#include <mpfr.h>

namespace {

class real {
  public:
    explicit real(const oracle::surd& x) {
        mpfr_init2(x_, 4000);
        mpfr_set_z(x_, x.d.get_mpz_t(), MPFR_RNDN);
        mpfr_sqrt(x_, x_, MPFR_RNDN);
        mpfr_mul_z(x_, x_, x.q.get_mpz_t(), MPFR_RNDN);
        mpfr_add_z(x_, x_, x.p.get_mpz_t(), MPFR_RNDN);
        mpfr_div_z(x_, x_, x.r.get_mpz_t(), MPFR_RNDN);
    }
    real(const real&) = delete;
    real& operator=(const real&) = delete;
    ~real() { mpfr_clear(x_); }

    double nearest() const { return mpfr_get_d(x_, MPFR_RNDN); }
    // The sign of x - y, which is 0 or above 2^-2000 in magnitude.
    int against(const real& y) const {
        mpfr_t difference;
        mpfr_init2(difference, 4000);
        mpfr_sub(difference, x_, y.x_, MPFR_RNDN);
        const bool zero = mpfr_zero_p(difference) || mpfr_get_exp(difference) < -2000;
        const int sign = zero ? 0 : mpfr_sgn(difference);
        mpfr_clear(difference);
        return sign < 0 ? -1 : sign > 0 ? 1 : 0;
    }

  private:
    mpfr_t x_;
};

long whole(long limit) { return property::in_range(-limit, limit + 1); }
oracle::surd draw(long limit, long roots) {
    return {whole(limit), whole(limit), property::in_range(0L, roots + 1), property::in_range(1L, limit + 1)};
}

} // namespace

TEST_CASE("surds are ordered as their values are") {
    CHECK(property::check("small ones, often equal", [] {
        const oracle::surd x = draw(3, 9), y = draw(3, 9);
        PROPERTY_ASSERT(oracle::compare(x, y) == real(x).against(real(y)));
    }));
    CHECK(property::check("large ones", [] {
        const oracle::surd x = draw(1L << 40, 1L << 50), y = draw(1L << 40, 1L << 50);
        PROPERTY_ASSERT(oracle::compare(x, y) == real(x).against(real(y)));
    }));
    CHECK(property::check("near ones", [] {
        oracle::surd x = draw(1L << 20, 1L << 20);
        PROPERTY_PRE(x.d > 0);
        oracle::surd y = x; // the same value over another root, and one slightly different
        y.d *= 9;
        y.p *= 3;
        y.r *= 3;
        PROPERTY_ASSERT(oracle::compare(x, y) == 0);
        y.d += property::one_of(-1, 1);
        PROPERTY_ASSERT(oracle::compare(x, y) == real(x).against(real(y)));
    }));
}

TEST_CASE("surds are rounded as MPFR rounds") {
    CHECK(property::check("any", [] {
        oracle::surd x = draw(1L << 40, 1L << 50);
        const auto k = property::in_range(-1200, 1100);
        (k < 0 ? x.r : x.q) <<= static_cast<unsigned long>(std::abs(k));
        (k < 0 ? x.r : x.p) <<= static_cast<unsigned long>(k < 0 ? 0 : k);
        PROPERTY_ASSERT(oracle::nearest_double(x) == real(x).nearest());
    }));
    // Exactly between two doubles, so it rounds to the even one.
    const graze::ball<2> a{{{1 + 0x1p-52, 0}}, {{-1, 0}}, 0x1p-53}, b{{{0, 0}}, {{0, 0}}, 0};
    CHECK(oracle::nearest_double(*oracle::meet(a, b).time) == 1);
    const graze::ball<2> c{{{1 + 0x1p-51, 0}}, {{-1, 0}}, 0x1p-53};
    CHECK(oracle::nearest_double(*oracle::meet(c, b).time) == 1 + 0x1p-51);
}

TEST_CASE("inputs of any exponent are lifted exactly") {
    oracle::group<double> g;
    const double values[] = {0x1p-1074, -0x1.fffffffffffffp+1023, 0.0, 0x1.8p-3, -3.0};
    for (const double x : values) {
        g.collect(x);
    }
    for (const double x : values) {
        CHECK(mpq_class(g.next() * g.unit()) == mpq_class(x));
    }
    oracle::group<mpq_class> h;
    h.collect(mpq_class(1, 6));
    h.collect(mpq_class(-3, 4));
    CHECK(mpq_class(h.next() * h.unit()) == mpq_class(1, 6));
    CHECK(mpq_class(h.next() * h.unit()) == mpq_class(-3, 4));
}
