// long_integer against GMP: sums, products and sums of products, with digits far apart.
#include "../machine/wide_values.hpp"

#include <graze/exact/long_integer.hpp>
#include <graze/linear/vec.hpp>

#include <doctest/doctest.h>

namespace {

using graze::detail::long_integer;

mpz_class value_of(const long_integer& x) {
    mpz_class sum = 0;
    for (int i = 0; i < x.count(); ++i) {
        RC_ASSERT(x.digit(i) != 0);
        RC_ASSERT(i == 0 || x.position(i) > x.position(i - 1));
        sum += mpz_class(static_cast<long>(x.digit(i))) * wide::power(64 * x.position(i));
    }
    RC_ASSERT(x.sign() == sgn(sum));
    return sum;
}

struct both {
    long_integer x;
    mpz_class exact;
};
both any_number() {
    const auto significand = *rc::gen::arbitrary<std::int64_t>();
    const int shift = *rc::gen::inRange(0, 4200);
    return {long_integer::from_shifted(significand, shift),
            mpz_class(static_cast<long>(significand)) * wide::power(shift)};
}

void check_same(const both& r) { RC_ASSERT(value_of(r.x) == r.exact); }

} // namespace

TEST_CASE("A long integer is what GMP says") {
    CHECK(rc::check("sums, differences and products", [] {
        const both x = any_number(), y = any_number(), z = any_number();
        check_same(x);
        const both sum{x.x + y.x, x.exact + y.exact}, difference{sum.x - z.x, sum.exact - z.exact};
        check_same(sum);
        check_same(difference);
        check_same({-difference.x, -difference.exact});
        const both product{sum.x * difference.x, sum.exact * difference.exact};
        check_same(product);
        check_same({product.x * product.x, product.exact * product.exact});
        long_integer copy = product.x;
        copy = x.x;
        check_same({copy, x.exact});
    }));
    CHECK(rc::check("inner products", [] {
        const both a = any_number(), b = any_number(), c = any_number(), d = any_number();
        check_same({graze::dot(graze::vec<2, long_integer>{{a.x, b.x}}, graze::vec<2, long_integer>{{c.x, d.x}}),
                    a.exact * c.exact + b.exact * d.exact});
        check_same({graze::dot(graze::vec<2, long_integer>{{a.x, b.x}}, graze::vec<2, long_integer>{{b.x, -a.x}}), 0});
    }));
    CHECK(graze::sign(long_integer(0)) == 0);
    static_assert((long_integer(3) * long_integer(-5)).sign() == -1);
}
