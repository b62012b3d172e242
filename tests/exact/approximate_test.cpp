// Wide integers as doubles: within 4u of the integer, in every rounding mode.
#include "../machine/wide_values.hpp"

#include <graze/exact/approximate.hpp>

#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <limits>

namespace exact_approximate_test {

namespace {

mpq_class value(const graze::detail::scaled_double& x) {
    const mpz_class p = wide::power(std::abs(x.exponent));
    return mpq_class(x.significand) * (x.exponent < 0 ? mpq_class(1, p) : mpq_class(p));
}

// u is 2^-52, which holds in every rounding mode.
template <class I>
void check(const I& x, const mpz_class& truth) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const graze::detail::scaled_double y = graze::detail::approximate(x);
        std::fesetround(FE_TONEAREST);
        PROPERTY_ASSERT(abs(value(y) - truth) * wide::power(50) <= abs(truth));
        PROPERTY_ASSERT(std::fabs(y.significand) < 0x1p65);
        PROPERTY_ASSERT(truth == 0 || std::fabs(y.significand) >= 0x1p-66);
    }
}

template <int Bits>
void check_integer() {
    const mpz_class truth = wide::any(property::in_range(1, Bits + 1));
    graze::integer<Bits> x;
    for (int i = 0; i < graze::integer<Bits>::limbs; ++i) {
        x.set_limb(i, wide::low_word(mpz_class(truth >> static_cast<unsigned long>(64 * i))));
    }
    check(x, truth);
}

void check_big() {
    graze::detail::workspace_of<2000> room;
    graze::detail::big_integer x;
    mpz_class truth;
    const int top = property::in_range(0, 31);
    for (int position = 0; position <= top; ++position) {
        const bool last = position == top;
        const auto digit = last || property::any<bool>() ? property::one_of(std::int64_t{1}, std::int64_t{-1},
                                                                            std::numeric_limits<std::int64_t>::min(),
                                                                            std::numeric_limits<std::int64_t>::max(),
                                                                            static_cast<std::int64_t>(wide::any_word()))
                                                         : 0;
        x = x + graze::detail::big_integer::from_shifted(room, digit, 64 * position);
        truth += wide::from_signed(digit) << static_cast<unsigned long>(64 * position);
    }
    check(x, truth);
}

} // namespace

TEST_CASE("Wide integers as doubles") {
    CHECK(property::check([] { check_integer<61>(); }));
    CHECK(property::check([] { check_integer<64>(); }));
    CHECK(property::check([] { check_integer<128>(); }));
    CHECK(property::check([] { check_integer<517>(); }));
    CHECK(property::check([] { check_big(); }));
    CHECK(graze::detail::approximate(graze::integer<200>()).significand == 0);
    CHECK(graze::detail::approximate(graze::detail::big_integer()).significand == 0);
}

TEST_CASE("Powers of two") {
    int wrong = 0;
    for (int e = -1022; e <= 1023; ++e) {
        wrong += graze::detail::power_of_two(e) == std::ldexp(1.0, e) ? 0 : 1;
    }
    CHECK(wrong == 0);
}

} // namespace exact_approximate_test
