// p + q√d, compared with MPFR. For whole p, q, d it is 0 or at least 1/(|p| + |q|√d), so enough digits decide its sign.
#include "../property.hpp"

#include <graze/number/adapter/gmp.hpp>
#include <graze/number/sqrt_extension.hpp>

#include <doctest/doctest.h>

#include <mpfr.h>

using graze::gmp_rational;
using extension = graze::sqrt_extension<gmp_rational>;

static_assert(graze::exact_number<extension> && graze::field_number<extension> && !graze::has_sqrt<extension>);

namespace {

class real {
  public:
    real() { mpfr_init2(x_, 600); }
    real(const real& y) : real() { mpfr_set(x_, y.x_, MPFR_RNDN); }
    real& operator=(const real&) = delete;
    ~real() { mpfr_clear(x_); }
    explicit real(const extension& e) : real() {
        const mpq_class p = e.p().value(), q = e.q().value(), d = e.d().value();
        mpfr_set_q(x_, d.get_mpq_t(), MPFR_RNDN);
        mpfr_sqrt(x_, x_, MPFR_RNDN);
        mpfr_mul_q(x_, x_, q.get_mpq_t(), MPFR_RNDN);
        mpfr_add_q(x_, x_, p.get_mpq_t(), MPFR_RNDN);
    }
    // For a value known to be 0 or above 2^-200 in magnitude.
    int sign() const { return mpfr_zero_p(x_) || mpfr_get_exp(x_) < -200 ? 0 : mpfr_sgn(x_); }
    friend real operator-(const real& x, const real& y) {
        real z;
        mpfr_sub(z.x_, x.x_, y.x_, MPFR_RNDN);
        return z;
    }

  private:
    mpfr_t x_;
};

int whole(int limit) { return property::in_range(-limit, limit + 1); }

// Small numbers make zeros and rational roots frequent; large ones with p² near q²d make near zeros.
extension draw(int d) { return {gmp_rational(whole(12)), gmp_rational(whole(4)), gmp_rational(d)}; }
int draw_radicand() { return property::one_of(0, 1, 2, 3, 4, 5, 7, 9, 16, 18, 100); }

} // namespace

TEST_CASE("the sign of p + q√d") {
    CHECK(property::check("small numbers", [] {
        const extension x = draw(draw_radicand());
        PROPERTY_ASSERT(x.sign() == real(x).sign());
    }));
    CHECK(property::check("p² beside q²d", [] {
        const auto q = property::in_range<long>(1, 1L << 40);
        const auto d = property::in_range<long>(1, 1L << 20);
        const mpz_class square = mpz_class(q) * q * d;
        const mpz_class p = sqrt(square) + whole(1);
        const int side = property::one_of(-1, 1);
        const gmp_rational first(mpq_class(side * p)), second(mpq_class(-side * mpz_class(q)));
        const extension x(first, second, gmp_rational(mpq_class(d)));
        PROPERTY_ASSERT(x.sign() == real(x).sign());
        PROPERTY_ASSERT(graze::sign_of_root_sum(x.p(), x.q(), x.d()) == real(x).sign());
    }));
}

TEST_CASE("a sqrt_extension is an ordered field") {
    CHECK(property::check("laws", [] {
        const int d = draw_radicand();
        const extension x = draw(d), y = draw(d), z = draw(d);
        PROPERTY_ASSERT((x + y) + z == x + (y + z));
        PROPERTY_ASSERT(x * y == y * x);
        PROPERTY_ASSERT((x * y) * z == x * (y * z));
        PROPERTY_ASSERT(x * (y + z) == x * y + x * z);
        PROPERTY_ASSERT(x - y == -(y - x));
        if (y.sign() != 0) {
            PROPERTY_ASSERT((x / y) * y == x);
        }
        PROPERTY_ASSERT(graze::sign(x * y) == x.sign() * y.sign());
        PROPERTY_ASSERT(((x <=> y) == 0) == ((real(x) - real(y)).sign() == 0));
        PROPERTY_ASSERT((x < y) == ((real(x) - real(y)).sign() < 0));
        PROPERTY_ASSERT((x < y) == (x + z < y + z));
    }));
    CHECK(property::check("its root is a root", [] {
        const gmp_rational d(property::in_range(0, 50));
        const extension r = graze::root(d);
        PROPERTY_ASSERT(r.sign() >= 0);
        PROPERTY_ASSERT(r * r == extension(d));
    }));
}

TEST_CASE("operands over different roots are refused, rational ones are not") {
    const gmp_rational one(1), two(2), three(3);
    const extension root2(one, one, two), root3(one, one, three);
    CHECK_THROWS_AS((void)(root2 + root3), std::domain_error);
    CHECK_THROWS_AS((void)(root2 * root3), std::domain_error);
    CHECK_THROWS_AS((void)(root2 / root3), std::domain_error);
    CHECK_THROWS_AS((void)(root2 < root3), std::domain_error);
    CHECK_THROWS_AS(extension(one, one, -two), std::domain_error);
    CHECK(root2 + extension(three) == extension(gmp_rational(4), one, two));
    CHECK(extension(three) * root2 == extension(three, three, two));
    CHECK(extension(three) / root3 * root3 == extension(three));
}
