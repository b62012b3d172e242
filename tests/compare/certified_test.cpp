// The numbers of the certified run, compared with GMP's rationals.
#include "../property.hpp"
#include "run/certified.hpp"

#include <doctest/doctest.h>

#include <gmpxx.h>

#include <cmath>
#include <utility>
#include <vector>

namespace certified_test {

using compare::exact;
using compare::run::certified;
using compare::run::mpfi_interval;

namespace {

bool contains(const certified& x, const mpq_class& value) {
    return mpfi_is_inside_q(value.get_mpq_t(), x.interval().get()) != 0;
}

exact exact_of(int numerator, int denominator) { return {numerator, denominator}; }

// A number and its true value.
struct pair {
    certified number;
    mpq_class value;
};

pair drawn(long bits) {
    const int numerator = property::in_range(-1000, 1000);
    const int denominator = property::in_range(1, 1000);
    const certified number(exact_of(numerator, denominator), bits);
    mpq_class value(numerator, denominator);
    value.canonicalize();
    return {property::any<bool>() ? number.enclosed() : number, value};
}

certified root_of(int x, long bits) { return sqrt(certified(exact(x), bits)); }

} // namespace

TEST_CASE("whatever is computed encloses the rational that GMP computes, and its sign is right or open") {
    CHECK(property::check([] {
        const long bits = property::in_range(4, 80);
        std::vector<pair> all{drawn(bits), drawn(bits), drawn(bits)};
        const int steps = property::in_range(1, 25);
        for (int i = 0; i < steps; ++i) {
            const pair x = all[property::in_range<std::size_t>(0, all.size())];
            const pair y = all[property::in_range<std::size_t>(0, all.size())];
            const int operation = property::in_range(0, 6);
            pair z;
            if (operation == 0) {
                z = {x.number + y.number, x.value + y.value};
            } else if (operation == 1) {
                z = {x.number - y.number, x.value - y.value};
            } else if (operation == 2) {
                z = {x.number * y.number, x.value * y.value};
            } else if (operation == 3) {
                z = {-x.number, -x.value};
            } else if (operation == 4) {
                z = {larger(x.number, y.number), x.value < y.value ? y.value : x.value};
            } else if (y.number.certain_sign().value_or(0) != 0) {
                z = {x.number / y.number, x.value / y.value};
            } else {
                continue;
            }
            PROPERTY_ASSERT(contains(z.number, z.value));
            PROPERTY_ASSERT(!z.number.is_rational() || z.number.rational() == z.value);
            if (const std::optional<int> sign = z.number.certain_sign()) {
                PROPERTY_ASSERT(*sign == sgn(z.value));
            }
            const graze::time_bounds bounds = z.number.bounds();
            PROPERTY_ASSERT(bounds.lower <= z.value);
            PROPERTY_ASSERT(z.value <= bounds.upper);
            all.push_back(z);
        }
    }));
}

TEST_CASE("a root of a rational's square is rational, any other is enclosed") {
    CHECK(property::check([] {
        const int numerator = property::in_range(0, 100'000), denominator = property::in_range(1, 100'000);
        const certified x(exact_of(numerator, denominator), 60);
        const certified root = sqrt(x * x);
        PROPERTY_ASSERT(root.is_rational());
        PROPERTY_ASSERT(root.rational() == x.rational());
        const certified irrational = sqrt(x * x + certified(exact_of(2, 1), 60) * x * x);
        PROPERTY_ASSERT(contains(irrational * irrational, 3 * x.rational() * x.rational()));
    }));
    CHECK(!root_of(2, 60).is_rational());
}

TEST_CASE("numbers of one quadratic field are exact, and their signs are certain") {
    CHECK(property::check([] {
        const int d = property::one_of(2, 3, 5, 6, 51, 1000);
        const mpq_class radicand(d);
        struct element { // p + q√d
            certified number;
            mpq_class p, q;
        };
        const auto element_of = [&](const mpq_class& p, const mpq_class& q) {
            const int square = property::in_range(1, 5); // √(d s²) = s √d, in the same field
            return element{certified(p, 60) + certified(mpq_class(q / square), 60) * root_of(d * square * square, 60),
                           p, q};
        };
        const auto draw = [&] { return element_of(drawn(60).value, drawn(60).value); };
        element x = draw(), y = draw();
        const mpq_class norm = y.p * y.p - y.q * y.q * radicand;
        for (const element& z :
             {element{x.number + y.number, x.p + y.p, x.q + y.q}, element{x.number - y.number, x.p - y.p, x.q - y.q},
              element{x.number * y.number, x.p * y.p + x.q * y.q * radicand, x.p * y.q + x.q * y.p},
              norm == 0 ? x
                        : element{x.number / y.number, (x.p * y.p - x.q * y.q * radicand) / norm,
                                  (x.q * y.p - x.p * y.q) / norm}}) {
            PROPERTY_ASSERT(z.number.is_exact());
            PROPERTY_ASSERT(z.number.is_rational() == (z.q == 0));
            // 400 bits of the root are enough: these numbers are 0 or larger than that.
            mpf_class root(0, 400);
            mpf_sqrt_ui(root.get_mpf_t(), static_cast<unsigned long>(d));
            const mpf_class value = mpf_class(z.p, 400) + mpf_class(z.q, 400) * root;
            const int sign = z.p == 0 && z.q == 0 ? 0 : sgn(value);
            PROPERTY_ASSERT(z.number.certain_sign() == sign);
            const mpfi_interval around = z.number.interval();
            const mpq_class near(value), off = abs(near) / (mpz_class(1) << 300);
            PROPERTY_ASSERT(mpfr_cmp_q(around.lower(), mpq_class(near + off).get_mpq_t()) <= 0);
            PROPERTY_ASSERT(mpfr_cmp_q(around.upper(), mpq_class(near - off).get_mpq_t()) >= 0);
            // The root of the square, whichever sign it has, is in the field too.
            const certified square_root = sqrt(z.number * z.number);
            PROPERTY_ASSERT(square_root.is_exact());
            PROPERTY_ASSERT((sign < 0 ? square_root + z.number : square_root - z.number).certain_sign() == 0);
        }
    }));
    CHECK(!(root_of(2, 60) + root_of(3, 60)).is_exact()); // of two fields
    CHECK(!sqrt(certified(1) + root_of(2, 60)).is_exact());
    CHECK((root_of(2, 60) * root_of(8, 60)).rational() == 4);
}

TEST_CASE("an exact number that nearly cancels is enclosed as closely as any") {
    // (√2 - 1)^200 is below 2^-254.
    certified x(1);
    for (int i = 0; i < 200; ++i) {
        x = x * (root_of(2, 60) - certified(1));
    }
    CHECK(x.is_exact());
    CHECK(x.certain_sign() == 1);
    CHECK(near_double(x) == doctest::Approx(std::pow(std::sqrt(2.0) - 1, 200)).epsilon(1e-12));
}

TEST_CASE("what shares an unknown number cancels exactly") {
    const certified x = root_of(2, 53).enclosed(), third(exact_of(1, 3), 53);
    CHECK((x - x).certain_sign() == 0);
    CHECK((third * x - x / certified(3)).certain_sign() == 0);
    CHECK((x / x).is_rational());
    CHECK((x * certified(0)).certain_sign() == 0);
    const certified y = root_of(2, 53).enclosed(); // the same number, but its interval does not say so
    CHECK(!(y - x).certain_sign());
    CHECK_THROWS_AS((void)(y - x).sign(), compare::run::undecided_sign);
}

TEST_CASE("an infinite mass has an inverse of exactly 0") {
    const certified infinite = certified::infinity();
    CHECK((certified(1) / infinite).certain_sign() == 0);
    CHECK(infinite.sign() == 1);
    CHECK(certified(5) < infinite);
    CHECK((infinite - infinite).certain_sign() == 0);
    CHECK_THROWS_AS(certified(1) / certified(0), std::domain_error);
}

TEST_CASE("a rational that is too long goes on as an interval around it") {
    certified x(exact_of(2, 3), 100);
    mpq_class value(2, 3);
    while (x.is_rational()) {
        x = x * x;
        value *= value;
        REQUIRE(mpz_sizeinbase(value.get_num_mpz_t(), 2) < 8 * certified::longest_exact);
    }
    CHECK(mpz_sizeinbase(value.get_den_mpz_t(), 2) > certified::longest_exact / 4);
    CHECK(contains(x, value));
    CHECK(x.sign() == 1);
}

} // namespace certified_test
