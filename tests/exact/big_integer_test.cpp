// big_integer against GMP: dense and far digits, extreme digits, carries, shared digits; and its workspace.
#include "../machine/wide_values.hpp"

#include <graze/exact/big_integer.hpp>
#include <graze/linear/vec.hpp>

#include <doctest/doctest.h>

#include <limits>

namespace {

using graze::detail::big_integer;
using graze::detail::to_big;
using graze::detail::workspace;
using wide::value;

constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

std::int64_t any_digit() {
    switch (property::in_range(0, 4)) {
    case 0:
        return property::one_of(least, most, least + 1, std::int64_t{-1}, std::int64_t{1});
    case 1:
        return static_cast<std::int64_t>(wide::any_word());
    default:
        return property::any<std::int64_t>();
    }
}

// Numbers of up to `digits` digits, close and far apart, some negated, some small constants.
big_integer any_value(workspace& w, int digits, mpz_class& truth) {
    if (property::in_range(0, 10) == 0) {
        const int small = property::in_range(-2, 3);
        truth = small;
        return small;
    }
    const int density = property::in_range(1, 5);
    big_integer x;
    truth = 0;
    for (int position = 0; position < digits; ++position) {
        if (property::in_range(0, density) == 0) {
            const std::int64_t digit = any_digit();
            x = x + big_integer::from_shifted(w, digit, 64 * position);
            truth += wide::from_signed(digit) * wide::power(64 * position);
        }
    }
    if (property::any<bool>()) {
        truth = -truth;
        return -x;
    }
    return x;
}

// What a value promises: its digits, size and sign.
void check(const big_integer& x, const mpz_class& truth) {
    PROPERTY_ASSERT(value(x) == truth);
    PROPERTY_ASSERT(graze::sign(x) == sgn(truth));
    if (x.count() != 0) {
        PROPERTY_ASSERT(x.digit(0) != 0);
        PROPERTY_ASSERT(x.digit(x.count() - 1) != 0);
    }
}

void check_pair(int most_x, int most_y) {
    graze::detail::workspace_of<20000> w;
    mpz_class a, b;
    const big_integer x = any_value(w, most_x, a);
    const big_integer y = any_value(w, most_y, b);
    check(x, a);
    check(y, b);
    check(x + y, a + b);
    check(x - y, a - b);
    check(y - x, b - a);
    check(x * y, a * b);
    check(-x, -a);
    check(x + x, 2 * a);
    check(x * x, a * a);
    PROPERTY_ASSERT((x - x).count() == 0);
    PROPERTY_ASSERT((x * big_integer()).count() == 0);
    PROPERTY_ASSERT((y * big_integer(0)).sign() == 0);
}

void check_vectors(int digits) {
    graze::detail::workspace_of<20000> w;
    mpz_class a[3], b[3];
    graze::vec<3, big_integer> x, y;
    for (int i = 0; i < 3; ++i) {
        x[i] = any_value(w, digits, a[i]);
        y[i] = any_value(w, digits, b[i]) + big_integer::from_shifted(w, 1, 0);
        b[i] += 1;
    }
    check(graze::dot(x, y), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    const auto normal = graze::cross(x, y);
    check(normal[0], a[1] * b[2] - a[2] * b[1]);
    check(normal[1], a[2] * b[0] - a[0] * b[2]);
    check(normal[2], a[0] * b[1] - a[1] * b[0]);
    const graze::vec<2, big_integer> u{{x[0], x[1]}}, v{{y[0], y[1]}};
    check(graze::dot(u, v), a[0] * b[0] + a[1] * b[1]);
    check(graze::squared_norm(v), b[0] * b[0] + b[1] * b[1]);
    check(graze::cross(u, v), a[0] * b[1] - a[1] * b[0]);
}

template <int Bits>
void check_integer() {
    const mpz_class truth = wide::any(Bits);
    graze::integer<Bits> x;
    for (int i = 0; i < graze::integer<Bits>::limbs; ++i) {
        x.set_limb(i, wide::low_word(mpz_class(truth >> static_cast<unsigned long>(64 * i))));
    }
    graze::detail::workspace_of<100> w;
    check(to_big(w, x), truth);
}

// Also in a constant expression, which may read only what has been written.
constexpr int sign_of_difference() {
    graze::detail::workspace_of<40> w;
    const auto x = big_integer::from_shifted(w, most, 130);
    const auto y = big_integer::from_shifted(w, least, 67);
    return ((x + y) * (x - y) - (x * x - y * y)).sign() + 10 * (x * y).sign() + 100 * (x + y).sign();
}

} // namespace

TEST_CASE("significand 2^shift") {
    graze::detail::workspace_of<20000> w;
    for (int shift = 0; shift < 2100; shift += shift < 130 ? 1 : 61) {
        for (const std::int64_t significand : {least, most, std::int64_t{1}, std::int64_t{-1}, std::int64_t{12345}}) {
            const workspace::scope scope(&w);
            const auto x = big_integer::from_shifted(w, significand, shift);
            CHECK(value(x) == wide::from_signed(significand) * wide::power(shift));
            CHECK(x.count() <= 2);
        }
    }
    CHECK(big_integer::from_shifted(w, 0, 77).count() == 0);
}

TEST_CASE("Sums, differences and products are GMP's") {
    CHECK(property::check([] { check_pair(1, 1); }));
    CHECK(property::check([] { check_pair(3, 3); }));
    CHECK(property::check([] { check_pair(33, 2); }));
    CHECK(property::check([] { check_pair(40, 90); }));
    CHECK(property::check([] { check_vectors(2); }));
    CHECK(property::check([] { check_vectors(35); }));
}

TEST_CASE("Integers of a width are the same numbers") {
    CHECK(property::check([] { check_integer<61>(); }));
    CHECK(property::check([] { check_integer<63>(); }));
    CHECK(property::check([] { check_integer<127>(); }));
    CHECK(property::check([] { check_integer<128>(); }));
    CHECK(property::check([] { check_integer<576>(); }));
}

TEST_CASE("Numbers far apart have zeros between them") {
    graze::detail::workspace_of<200> w;
    const auto large = big_integer::from_shifted(w, 1, 2000);
    const auto x = large - 1;
    CHECK(value(x) == wide::power(2000) - 1);
    int digits = 0;
    for (int i = 0; i < x.count(); ++i) {
        digits += x.digit(i) != 0 ? 1 : 0;
    }
    CHECK(digits == 2); // the borrow does not run through all digits
}

TEST_CASE("What a scope has taken is given back") {
    graze::detail::workspace_of<6> w;
    const auto x = big_integer::from_shifted(w, most, 3);
    for (int i = 0; i < 100; ++i) { // if room were not given back, the program would end
        const workspace::scope scope(&w);
        CHECK(value(x * x) == value(x) * value(x));
    }
    static_assert(sign_of_difference() == 90);
}
