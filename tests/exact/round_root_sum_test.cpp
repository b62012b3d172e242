// The one rounding routine, compared with the oracle: numbers of every size, ties, numbers closer to a tie than any
// estimate can tell, the ends of the formats. Its parts, the leading bits and their arithmetic, are compared with GMP.
#include "../environments/state.hpp"
#include "../machine/wide_values.hpp"
#include "../oracle/rounding.hpp"

#include <graze/exact/round_root_sum.hpp>

#include <doctest/doctest.h>

#include <bit>

namespace {

using graze::rounding;
using graze::detail::big_integer;
using graze::detail::leading;
using graze::detail::leading_of;

mpq_class power(int exponent) {
    const mpz_class p = wide::power(std::abs(exponent));
    return exponent < 0 ? mpq_class(1, p) : mpq_class(p);
}

template <int Bits>
void make(const mpz_class& value, graze::integer<Bits>& x) {
    for (int i = 0; i < graze::integer<Bits>::limbs; ++i) {
        x.set_limb(i, wide::low_word(mpz_class(value >> static_cast<unsigned long>(64 * i))));
    }
}
graze::detail::workspace_of<100000> room; // every check gives back the room that it takes
void make(mpz_class value, big_integer& x) {
    x = big_integer();
    for (int i = 0; value != 0; ++i) {
        const auto digit = static_cast<std::int64_t>(wide::low_word(value));
        x = x + big_integer::from_shifted(room, digit, 64 * i);
        value = (value - wide::from_signed(digit)) >> 64;
    }
}
template <class Z>
Z make(const mpz_class& value) {
    Z x;
    make(value, x);
    return x;
}

// A number whose true value is within the range of its leading bits.
struct tracked {
    leading bits;
    mpq_class truth;
};

bool holds(const tracked& t) {
    if (t.bits.significand == 0) {
        return t.bits.error != 0 || t.truth == 0;
    }
    const mpq_class middle = mpq_class(wide::from_unsigned(t.bits.significand)) * (t.bits.negative ? -1 : 1);
    const mpq_class off = abs(mpq_class(t.truth - middle * power(t.bits.exponent)));
    return t.bits.significand >> 63 != 0 &&
           off <= mpq_class(wide::from_unsigned(t.bits.error)) * power(t.bits.exponent);
}

template <class Z>
tracked draw(int bits) {
    const mpz_class x = wide::any(property::in_range(1, bits + 1));
    return {leading_of(make<Z>(x)), x};
}
// The same with an error of some bits; now and then the truth is at the end of the range.
tracked blurred() {
    tracked t = draw<graze::integer<300>>(300);
    if (t.bits.significand != 0 && property::any<bool>()) {
        t.bits.error += std::uint64_t{1} << property::in_range(0, 36);
        const mpz_class end =
            wide::from_unsigned(t.bits.significand) + property::one_of(1, -1) * wide::from_unsigned(t.bits.error);
        t.truth = mpq_class(t.bits.negative ? mpz_class(-end) : end) * power(t.bits.exponent);
    }
    return t;
}

constexpr rounding modes[] = {rounding::nearest, rounding::downward, rounding::upward};

oracle::surd scaled(const mpz_class& p, const mpz_class& q, const mpz_class& d, const mpz_class& r, int scale) {
    const mpz_class up = wide::power(scale > 0 ? scale : 0);
    return {p * up, q * up, d, r * wide::power(scale < 0 ? -scale : 0)};
}

template <class T, class Z>
bool rounds(const mpz_class& p, const mpz_class& q, const mpz_class& d, const mpz_class& r, int scale) {
    const graze::detail::workspace::scope scope(&room);
    const graze::radicand<Z> root(make<Z>(d));
    bool right = true;
    for (const rounding mode : modes) {
        const T y = graze::round_to<T>(make<Z>(p), make<Z>(q), root, make<Z>(r), scale, mode);
        right = right && oracle::is_rounded(scaled(p, q, d, r, scale), y, static_cast<oracle::direction>(mode));
    }
    return right;
}
template <class T>
void round(const mpz_class& p, const mpz_class& q, const mpz_class& d, const mpz_class& r, int scale) {
    PROPERTY_ASSERT((rounds<T, graze::integer<576>>(p, q, d, r, scale)));
    PROPERTY_ASSERT((rounds<T, graze::integer<1152>>(p, q, d, r, scale)));
    PROPERTY_ASSERT((rounds<T, big_integer>(p, q, d, r, scale)));
}
void round_both(const mpz_class& p, const mpz_class& q, const mpz_class& d, const mpz_class& r, int scale) {
    round<double>(p, q, d, r, scale);
    round<float>(p, q, d, r, scale);
}

mpz_class any_of(int bits) { return wide::any(property::in_range(1, bits + 1)); }
mpz_class positive(int bits) { return abs(any_of(bits)) + 1; }

} // namespace

TEST_CASE("quotients and roots of two words") {
    using namespace graze::detail;
    CHECK(property::check("quotient", [] {
        const std::uint64_t divisor = wide::any_word() | std::uint64_t{1} << 63;
        const std::uint64_t high = wide::any_word() % divisor;
        const std::uint64_t low = wide::any_word();
        const mpz_class truth =
            (wide::from_unsigned(high) * wide::power(64) + wide::from_unsigned(low)) / wide::from_unsigned(divisor);
        PROPERTY_ASSERT(wide::from_unsigned(divide(high, low, divisor)) == truth);
        PROPERTY_ASSERT(wide::from_unsigned(divide_portable(high, low, divisor)) == truth);
    }));
    CHECK(property::check("root", [] {
        const std::uint64_t high = wide::any_word() | std::uint64_t{1} << (62 + property::in_range(0, 2));
        const std::uint64_t low = wide::any_word();
        const mpz_class n = wide::from_unsigned(high) * wide::power(64) + wide::from_unsigned(low);
        const mpz_class root = wide::from_unsigned(square_root(high, low));
        PROPERTY_ASSERT((root - 1) * (root - 1) <= n);
        PROPERTY_ASSERT(n <= (root + 1) * (root + 1));
        const mpz_class floor = sqrt(wide::from_unsigned(high));
        PROPERTY_ASSERT(wide::from_unsigned(square_root(high)) == floor);
    }));
    static_assert(square_root(std::uint64_t{99}) == 9 && square_root(~std::uint64_t{0}) == 0xffffffffU);
}

TEST_CASE("leading bits are as good as they say") {
    CHECK(property::check("of integers", [] {
        PROPERTY_ASSERT(holds(draw<graze::integer<576>>(576)));
        const graze::detail::workspace::scope scope(&room);
        PROPERTY_ASSERT(holds(draw<big_integer>(2000)));
    }));
    CHECK(property::check("of big integers with digits at their ends", [] {
        const graze::detail::workspace::scope scope(&room);
        big_integer x;
        mpz_class truth;
        for (int position = 0; position < 9; ++position) {
            const std::int64_t digit =
                property::one_of(std::int64_t{0}, std::int64_t{1}, std::int64_t{-1},
                                 std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
            x = x + big_integer::from_shifted(room, digit, 64 * position);
            truth += wide::from_signed(digit) << static_cast<unsigned long>(64 * position);
        }
        PROPERTY_ASSERT(holds({leading_of(x), truth}));
    }));
    CHECK(property::check("of products, quotients, sums and roots", [] {
        const tracked x = blurred(), y = blurred();
        PROPERTY_ASSERT(holds({x.bits * y.bits, x.truth * y.truth}));
        PROPERTY_ASSERT(holds({x.bits + y.bits, x.truth + y.truth}));
        if (y.bits.significand != 0) {
            PROPERTY_ASSERT(holds({x.bits / y.bits, x.truth / y.truth}));
        }
        if (!x.bits.negative) {
            const leading root = graze::detail::square_root(x.bits);
            const auto square = [](const mpz_class& z) { return mpq_class(z * z); };
            const mpz_class middle = wide::from_unsigned(root.significand), error = wide::from_unsigned(root.error);
            PROPERTY_ASSERT(square(middle - error) * power(2 * root.exponent) <= x.truth);
            PROPERTY_ASSERT(x.truth <= square(middle + error) * power(2 * root.exponent));
        }
    }));
    CHECK(property::check("of differences that cancel", [] {
        tracked x = blurred(), y = x;
        y.bits.negative = !y.bits.negative;
        y.bits.significand ^= y.bits.significand != 0 ? std::uint64_t{1} << property::in_range(0, 63) : 0;
        y.bits.error = 0;
        y.truth =
            mpq_class(wide::from_unsigned(y.bits.significand)) * (y.bits.negative ? -1 : 1) * power(y.bits.exponent);
        PROPERTY_ASSERT(holds({x.bits + y.bits, x.truth + y.truth}));
    }));
}

TEST_CASE("any number is rounded correctly") {
    CHECK(property::check("of any size", [] {
        round_both(any_of(500), any_of(250), abs(any_of(500)), positive(500), property::in_range(-1400, 1400));
    }));
    CHECK(property::check("small and often equal", [] {
        round_both(any_of(5), any_of(3), abs(any_of(4)), positive(4), property::in_range(-8, 9));
    }));
    CHECK(property::check("at the ends of the formats", [] {
        const int scale = property::one_of(-1074, -1022, -149, -126, 127, 1023) + property::in_range(-56, 2);
        round_both(any_of(60), any_of(4), abs(any_of(6)), mpz_class(1), scale);
    }));
    CHECK(property::check("of the largest scales", [] {
        round_both(any_of(300), any_of(30), abs(any_of(500)), positive(200), property::one_of(-2098, 2098));
    }));
}

TEST_CASE("ties, and what is beside them by less than any estimate tells") {
    // For d = k² + e the root is about k + e/(2k), and (p + q√d)/r about m + qe/(2kr) for a number or a middle m.
    CHECK(property::check("beside", [] {
        const int digits = property::one_of(24, 25, 53, 54, 10);
        const mpz_class m = wide::power(digits - 1) + abs(any_of(digits)) % wide::power(digits - 1);
        const mpz_class k = positive(240), r = positive(200), q = any_of(200);
        const mpz_class p = m * r - q * k;
        const int scale =
            property::one_of(0, -1074, -1075, -1100, -149, -150, -160, 970, 103) + property::in_range(-1, 2);
        round_both(p, q, k * k + property::in_range(-1, 2), r, scale);
        round_both(-p, -q, k * k + property::in_range(-1, 2), r, scale);
    }));
    CHECK(property::check("around zero", [] {
        const mpz_class k = positive(240), q = any_of(200);
        round_both(-q * k, q, k * k + property::in_range(-1, 2), positive(300), property::in_range(-900, 900));
    }));
    CHECK(property::check("where nearly all bits cancel", [] {
        const mpz_class k = positive(240), q = any_of(200);
        round_both(-q * k + property::in_range(-2, 3), q, k * k + any_of(120) * (k >= wide::power(130) ? 1 : 0),
                   positive(300), property::in_range(-900, 900));
    }));
}

TEST_CASE("overflow, underflow and zero") {
    using Z = graze::integer<576>;
    const auto round = [](long p, long r, int scale, rounding mode) {
        return graze::round_to<double>(Z(static_cast<std::int64_t>(p)), Z(0), graze::radicand<Z>(),
                                       Z(static_cast<std::int64_t>(r)), scale, mode);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double smallest = std::numeric_limits<double>::denorm_min();
    CHECK(round(1, 1, 1024, rounding::nearest) == infinity);
    CHECK(round(1, 1, 1024, rounding::downward) == largest);
    CHECK(round(-1, 1, 1024, rounding::upward) == -largest);
    CHECK(round(-1, 1, 2098, rounding::downward) == -infinity);
    CHECK(round((1L << 54) - 1, 1, 970, rounding::nearest) == infinity); // the middle beyond the largest number
    CHECK(round((1L << 55) - 3, 1, 969, rounding::nearest) == largest);
    CHECK(round(1, 1, -1075, rounding::nearest) == 0);
    CHECK(round(3, 1, -1075, rounding::nearest) == 2 * smallest);
    CHECK(round(1, 1, -2098, rounding::upward) == smallest);
    CHECK(std::signbit(round(-1, 1, -2098, rounding::nearest)));
    CHECK(std::bit_cast<std::uint64_t>(round(0, 7, 5, rounding::downward)) == 0);
    static_assert(graze::round_to<double>(Z(1), Z(0), graze::radicand<Z>(), Z(3), 0) == 1.0 / 3);
    static_assert(graze::round_to<float>(Z(0), Z(1), graze::radicand<Z>(Z(2)), Z(1), 0) == 0x1.6a09e6p+0F);
}

TEST_CASE("the state of the floating-point environment has no part in it") {
    using Z = graze::integer<576>;
    const graze::radicand<Z> two(Z(2));
    environments::save_state();
    for (const auto direction : {environments::rounding::nearest, environments::rounding::upward,
                                 environments::rounding::downward, environments::rounding::towards_zero}) {
        for (const bool flush : {false, true}) {
            if (flush && !environments::can_flush()) {
                continue;
            }
            const bool set = environments::set_state(direction, flush);
            const double normal = graze::round_to<double>(Z(0), Z(1), graze::radicand<Z>(Z(2)), Z(1), 0);
            const double subnormal = graze::round_to<double>(Z(0), Z(1), two, Z(1), -1060);
            const float small = graze::round_to<float>(Z(0), Z(-1), two, Z(1), -140);
            environments::restore_state();
            REQUIRE(set);
            CHECK(std::bit_cast<std::uint64_t>(normal) == std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp+0));
            CHECK(std::bit_cast<std::uint64_t>(subnormal) == std::bit_cast<std::uint64_t>(0x1.6a08p-1060));
            CHECK(std::bit_cast<std::uint32_t>(small) == std::bit_cast<std::uint32_t>(-0x1.6ap-140F));
        }
    }
}
