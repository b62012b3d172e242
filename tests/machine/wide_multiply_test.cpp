// Products and sums of words: the path in use and the portable one, compared with GMP.
#include "wide_values.hpp"

#include <graze/machine/wide_multiply.hpp>

#include <doctest/doctest.h>

#include <limits>

namespace {

using graze::detail::two_limbs;
using wide::from_signed;
using wide::from_unsigned;

mpz_class value(const two_limbs& x) { return (from_unsigned(x.high) << 64) + from_unsigned(x.low); }

void check_pair(std::uint64_t x, std::uint64_t y) {
    const mpz_class product = from_unsigned(x) * from_unsigned(y);
    PROPERTY_ASSERT(value(graze::detail::multiply_portable(x, y)) == product);
    PROPERTY_ASSERT(value(graze::detail::multiply(x, y)) == product);
}

constexpr auto most = std::numeric_limits<std::uint64_t>::max();
static_assert(graze::detail::multiply_portable(most, most).high == most - 1);
static_assert(graze::detail::multiply(most, most).low == 1);
static_assert(graze::detail::multiply_add(most, most, most, most).high == most); // the largest: 2^128 - 1
static_assert(graze::detail::multiply_add(most, most, most, most).low == most);
constexpr auto least = std::numeric_limits<std::int64_t>::min();
static_assert(graze::detail::multiply_add_balanced(least, least, least, least).high == (std::int64_t{1} << 62) - 1);

} // namespace

TEST_CASE("Products of two words") {
    CHECK(property::check([] { check_pair(wide::any_word(), wide::any_word()); }));
    CHECK(property::check([] {
        const std::uint64_t x = wide::any_word(), y = wide::any_word(), addend = wide::any_word(),
                            carry = wide::any_word();
        PROPERTY_ASSERT(value(graze::detail::multiply_add(x, y, addend, carry)) ==
                        from_unsigned(x) * from_unsigned(y) + from_unsigned(addend) + from_unsigned(carry));
    }));
}

TEST_CASE("Sums of two words and a carry") {
    CHECK(property::check([] {
        const std::uint64_t x = wide::any_word(), y = wide::any_word();
        const std::uint64_t before = property::in_range<std::uint64_t>(0, 2);
        std::uint64_t carry = before;
        const std::uint64_t sum = graze::detail::add_with_carry(x, y, carry);
        PROPERTY_ASSERT(carry <= 1U);
        PROPERTY_ASSERT(value({sum, carry}) == from_unsigned(x) + from_unsigned(y) + from_unsigned(before));
    }));
}

TEST_CASE("Signed products with a balanced low word") {
    CHECK(property::check([] {
        const auto any = [] { return static_cast<std::int64_t>(wide::any_word()); };
        const std::int64_t x = any(), y = any(), addend = any(), carry = any();
        const auto sum = graze::detail::multiply_add_balanced(x, y, addend, carry);
        PROPERTY_ASSERT((from_signed(sum.high) << 64) + from_signed(sum.low) ==
                        from_signed(x) * from_signed(y) + from_signed(addend) + from_signed(carry));
    }));
}
