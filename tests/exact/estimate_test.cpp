// Estimates: the exact value is within the stated error, through sums and products of any sizes.
#include "../machine/wide_values.hpp"

#include <graze/exact/estimate.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <vector>

namespace exact_estimate_test {

namespace {

using graze::detail::estimate;

mpq_class scaled(double x, int exponent) {
    const mpz_class p = wide::power(std::abs(exponent));
    return mpq_class(x) * (exponent < 0 ? mpq_class(1, p) : mpq_class(p));
}

void check(const estimate& x, const mpz_class& truth) {
    PROPERTY_ASSERT(std::isfinite(x.value));
    PROPERTY_ASSERT(std::isfinite(x.error));
    PROPERTY_ASSERT(abs(scaled(x.value, x.exponent) - truth) <= scaled(x.error, x.exponent));
    if (graze::detail::is_certain(x)) {
        PROPERTY_ASSERT(sgn(truth) == (x.value < 0 ? -1 : 1));
    }
}

graze::detail::big_integer any_big(graze::detail::workspace& room, mpz_class& truth) {
    const auto significand = static_cast<std::int64_t>(wide::any_word()) >> property::in_range(1, 63);
    const int shift = property::in_range(0, 2030);
    truth = wide::from_signed(significand) * wide::power(shift);
    return graze::detail::big_integer::from_shifted(room, significand, shift);
}

// A random formula of 20 sums, differences and products, degrees up to 10.
void check_formula() {
    struct term {
        estimate x;
        mpz_class truth;
        int degree;
    };
    static constexpr int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    const int mode = modes[property::in_range(0, 4)];
    graze::detail::workspace_of<20> room;
    std::vector<term> terms;
    for (int i = 0; i < 4; ++i) {
        mpz_class truth;
        const auto x = any_big(room, truth);
        terms.push_back({graze::detail::estimate_of(x), truth, 1});
    }
    for (int i = 0; i < 20; ++i) {
        const term x = terms[static_cast<std::size_t>(property::in_range(0, static_cast<int>(terms.size())))];
        const term y = terms[static_cast<std::size_t>(property::in_range(0, static_cast<int>(terms.size())))];
        const int operation = property::in_range(0, x.degree + y.degree <= 10 ? 3 : 2);
        std::fesetround(mode);
        const estimate r = operation == 0 ? x.x + y.x : operation == 1 ? x.x - y.x : x.x * y.x;
        std::fesetround(FE_TONEAREST);
        const mpz_class truth = operation == 0   ? mpz_class(x.truth + y.truth)
                                : operation == 1 ? mpz_class(x.truth - y.truth)
                                                 : mpz_class(x.truth * y.truth);
        check(r, truth);
        terms.push_back({r, truth, operation == 2 ? x.degree + y.degree : std::max(x.degree, y.degree)});
    }
}

} // namespace

TEST_CASE("An estimate's error holds through formulas") {
    CHECK(property::check([] { check_formula(); }));
}

TEST_CASE("An estimate of a plain value is certain, of a cancelled one not") {
    const auto x = graze::detail::estimate_of(graze::integer<61>(7));
    const auto y = graze::detail::estimate_of(graze::integer<61>(-5));
    CHECK(graze::detail::is_certain(x * y));
    CHECK((x * y).value < 0);
    CHECK(graze::detail::is_certain(x + y));
    CHECK_FALSE(graze::detail::is_certain(x - x));
    CHECK_FALSE(graze::detail::is_certain(estimate(0)));
}

} // namespace exact_estimate_test
