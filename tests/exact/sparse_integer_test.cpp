// sparse_integer<Bits> against GMP: far digits, extreme digits, carries.
#include "../machine/wide_values.hpp"

#include <graze/exact/sparse_integer.hpp>
#include <graze/linear/vec.hpp>

#include <doctest/doctest.h>

#include <limits>

namespace {

using graze::sparse_integer;
using wide::value;

constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

// What a value promises: its digits, its size and its sign.
template <int Bits>
void check_form(const sparse_integer<Bits>& x) {
    RC_ASSERT(x.count() <= sparse_integer<Bits>::capacity);
    for (int i = 0; i < x.count(); ++i) {
        RC_ASSERT(x.digit(i) != 0);
        RC_ASSERT(i == 0 || x.position(i) > x.position(i - 1));
        RC_ASSERT(x.position(i) >= 0);
    }
    const mpz_class sum = value(x);
    RC_ASSERT(abs(sum) < wide::power(Bits));
    RC_ASSERT(x.sign() == sgn(sum));
    RC_ASSERT(graze::sign(x) == sgn(sum));
}

std::int64_t any_digit() {
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return *rc::gen::element(least, most, least + 1, std::int64_t{-1}, std::int64_t{1});
    case 1:
        return static_cast<std::int64_t>(wide::any_word());
    default:
        return *rc::gen::arbitrary<std::int64_t>();
    }
}

// Digits at near and far positions, below 2^Bits by two limbs at most.
template <int Bits>
sparse_integer<Bits> any_value() {
    sparse_integer<Bits> x;
    const int density = *rc::gen::inRange(1, 5);
    for (int position = 0; position + 2 <= Bits / 64; ++position) {
        if (*rc::gen::inRange(0, density) == 0) {
            x.append(position, any_digit());
        }
    }
    return x;
}

template <int A, int B>
void check_pair() {
    const auto x = any_value<A>();
    const auto y = any_value<B>();
    const mpz_class a = value(x), b = value(y);
    check_form(x);
    static_assert(std::is_same_v<decltype(x + y), sparse_integer<(A > B ? A : B) + 1>>);
    static_assert(std::is_same_v<decltype(x * y), sparse_integer<A + B>>);
    check_form(x + y);
    check_form(x - y);
    check_form(x * y);
    check_form(-x);
    RC_ASSERT(value(x + y) == a + b);
    RC_ASSERT(value(x - y) == a - b);
    RC_ASSERT(value(x * y) == a * b);
    RC_ASSERT(value(-x) == -a);
    RC_ASSERT((x - x).count() == 0);
    RC_ASSERT((x * sparse_integer<B>()).count() == 0);
    if constexpr (A < B) {
        RC_ASSERT(value(sparse_integer<B>(x)) == a);
    }
}

template <int A, int B>
void check_dot() {
    const graze::vec<3, sparse_integer<A>> x{{any_value<A>(), any_value<A>(), any_value<A>()}};
    const graze::vec<3, sparse_integer<B>> y{{any_value<B>(), any_value<B>(), any_value<B>()}};
    const auto product = graze::dot(x, y);
    check_form(product);
    RC_ASSERT(value(product) == value(x[0]) * value(y[0]) + value(x[1]) * value(y[1]) + value(x[2]) * value(y[2]));
    const auto norm = graze::squared_norm(x);
    RC_ASSERT(value(norm) == value(x[0]) * value(x[0]) + value(x[1]) * value(x[1]) + value(x[2]) * value(x[2]));
    const auto normal = graze::cross(x, y);
    RC_ASSERT(value(normal[2]) == value(x[0]) * value(y[1]) - value(x[1]) * value(y[0]));
}

} // namespace

TEST_CASE("significand 2^shift") {
    CHECK(rc::check([] {
        const std::int64_t significand = any_digit();
        const int shift = *rc::gen::inRange(0, 2035);
        const auto x = sparse_integer<2098>::from_shifted(significand, shift);
        check_form(x);
        RC_ASSERT(x.count() <= 2);
        RC_ASSERT(value(x) == wide::from_signed(significand) << static_cast<unsigned long>(shift));
    }));
    CHECK(value(sparse_integer<64>(-7)) == -7);
    for (int shift = 0; shift < 130; ++shift) {
        for (const std::int64_t significand : {least, most, std::int64_t{1}, std::int64_t{-1}}) {
            CHECK(value(sparse_integer<200>::from_shifted(significand, shift)) ==
                  wide::from_signed(significand) << static_cast<unsigned long>(shift));
        }
    }
}

TEST_CASE("Sums, differences and products are GMP's") {
    CHECK(rc::check([] { check_pair<200, 200>(); }));
    CHECK(rc::check([] { check_pair<2098, 2098>(); }));
    CHECK(rc::check([] { check_pair<300, 6000>(); }));
    CHECK(rc::check([] { check_pair<9000, 130>(); }));
}

TEST_CASE("Products of vectors share an accumulator") {
    CHECK(rc::check([] { check_dot<200, 200>(); }));
    CHECK(rc::check([] { check_dot<4200, 2100>(); }));
}

TEST_CASE("A carry is one more digit and does not run through zeros") {
    const auto large = sparse_integer<2098>::from_shifted(1, 2000);
    const auto one = sparse_integer<2098>(1);
    CHECK((large - one).count() == 2);
    CHECK((large - one).sign() == 1);
    CHECK((one - large).sign() == -1);
    CHECK(value(large - one) == wide::power(2000) - 1);
    const auto square = (large - one) * (large - one);
    CHECK(square.count() == 3);
    CHECK(value(square) == (wide::power(2000) - 1) * (wide::power(2000) - 1));
}
