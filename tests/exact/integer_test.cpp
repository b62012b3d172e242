// integer<Bits> against GMP, at widths around the borders of limbs.
#include "../machine/wide_values.hpp"

#include <graze/exact/integer.hpp>

#include <doctest/doctest.h>

#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>

namespace {

using graze::integer;
using wide::value;

template <int Bits>
integer<Bits> in(const mpz_class& x) {
    integer<Bits> r;
    for (int i = 0; i < integer<Bits>::limbs; ++i) {
        r.set_limb(i, wide::low_word(mpz_class(x >> static_cast<unsigned long>(64 * i))));
    }
    return r;
}

template <int A, int B>
void check_pair() {
    const mpz_class x = wide::any(A), y = wide::any(B);
    const auto a = in<A>(x);
    const auto b = in<B>(y);
    static_assert(std::is_same_v<decltype(a + b), integer<(A > B ? A : B) + 1>>);
    static_assert(std::is_same_v<decltype(a - b), integer<(A > B ? A : B) + 1>>);
    static_assert(std::is_same_v<decltype(a * b), integer<A + B>>);
    PROPERTY_ASSERT(value(a + b) == x + y);
    PROPERTY_ASSERT(value(a - b) == x - y);
    PROPERTY_ASSERT(value(a * b) == x * y);
    PROPERTY_ASSERT(value(a * -b) == -(x * y));
    if constexpr (A < B) {
        PROPERTY_ASSERT(value(integer<B>(a)) == x);
    }
}

template <int Bits>
void check_one() {
    const mpz_class x = wide::any(Bits), y = wide::any(Bits);
    const auto a = in<Bits>(x), b = in<Bits>(y);
    PROPERTY_ASSERT(value(-a) == -x);
    PROPERTY_ASSERT(graze::sign(a) == sgn(x));
    PROPERTY_ASSERT(a.is_negative() == (x < 0));
    PROPERTY_ASSERT((a == b) == (x == y));
    PROPERTY_ASSERT((a <=> b) == (cmp(x, y) <=> 0));
    PROPERTY_ASSERT(a == in<Bits>(x));
    PROPERTY_ASSERT(a.limb(integer<Bits>::limbs) == (x < 0 ? ~std::uint64_t{0} : 0U)); // beyond the last

    // significand 2^shift, as large as the width allows.
    const int bits = property::in_range(1, std::min(Bits, 63) + 1);
    const int shift = property::in_range(0, Bits - bits + 1);
    const mpz_class significand = wide::any(bits);
    const auto word = static_cast<std::int64_t>(wide::low_word(significand));
    PROPERTY_ASSERT(value(integer<Bits>::from_shifted(word, shift)) == significand
                                                                           << static_cast<unsigned long>(shift));
}

template <int A, int... B>
bool holds_beside(std::integer_sequence<int, B...>) {
    return (property::check([] { check_pair<A, B>(); }) && ...) && property::check([] { check_one<A>(); });
}
template <int... A>
bool holds_for_all(std::integer_sequence<int, A...> widths) {
    return (holds_beside<A>(widths) && ...);
}

// Words that fit a width convert; a word that may not fit does not.
static_assert(std::constructible_from<integer<64>, std::int64_t> &&
              !std::constructible_from<integer<63>, std::int64_t>);
static_assert(std::constructible_from<integer<32>, std::int32_t> && std::constructible_from<integer<3>, int>);
static_assert(!std::constructible_from<integer<64>, std::uint64_t> && !std::constructible_from<integer<64>, double>);
static_assert(std::convertible_to<integer<5>, integer<6>> && !std::constructible_from<integer<5>, integer<6>>);
static_assert(graze::exact_number<integer<62>> && graze::exact_number<integer<129>>);

// Also at compile time: (2^62 - 1)² and the like.
constexpr auto largest = integer<64>(std::numeric_limits<std::int64_t>::max());
static_assert((largest * largest).limb(0) == 1 && (largest * largest).limb(1) == 0x3fffffffffffffff);
static_assert((largest * -largest).sign() == -1 && (largest - largest).sign() == 0);
static_assert(integer<64>(std::numeric_limits<std::int64_t>::min()) < -largest);

} // namespace

TEST_CASE("Sums, differences, products and signs are GMP's, at every width") {
    CHECK(holds_for_all(std::integer_sequence<int, 1, 61, 64, 65, 127, 192, 300>()));
}
