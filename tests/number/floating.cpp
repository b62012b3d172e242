// The square root in constant expressions against the processor's, which IEEE 754 requires to be correctly rounded.
#include <graze/number/floating.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using limits = std::numeric_limits<double>;
using graze::detail::constant_sqrt;

static_assert(graze::square_root(2.0) == 0x1.6a09e667f3bcdp+0);
static_assert(graze::square_root(2.0f) == 0x1.6a09e6p+0f);
static_assert(graze::square_root(0.0) == 0.0);
static_assert(graze::square_root(limits::denorm_min()) == 0x1p-537);
static_assert(graze::square_root(limits::max()) == 0x1.fffffffffffffp+511);
static_assert(graze::square_root(std::numeric_limits<float>::denorm_min()) == 0x1.6a09e6p-75f);
static_assert(graze::square_root(limits::infinity()) == limits::infinity());
static_assert(graze::square_root(-1.0) != graze::square_root(-1.0)); // NaN

static bool same_bits(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }

static long differences = 0;
static void compare(double x) { differences += same_bits(constant_sqrt(x), std::sqrt(x)) ? 0 : 1; }

TEST_CASE("constant_sqrt on random bits, all exponents") {
    std::mt19937_64 bits(20230607);
    differences = 0;
    for (int i = 0; i < 300'000; ++i) {
        compare(std::bit_cast<double>(bits() & ~(std::uint64_t{1} << 63) & ~(std::uint64_t{1} << 62))); // below 2
        compare(std::abs(std::bit_cast<double>((bits() & 0x800fffffffffffff) | 0x3ff0000000000000)) * 4);
    }
    CHECK(differences == 0);
}

TEST_CASE("constant_sqrt on subnormals") {
    std::mt19937_64 bits(20230608);
    differences = 0;
    for (int shift = 0; shift < 53; ++shift) {
        for (int i = 0; i < 2000; ++i) {
            compare(std::bit_cast<double>((bits() >> 12) >> shift));
        }
    }
    CHECK(differences == 0);
}

// The hardest cases: x next to the square of a middle between two doubles, and next to squares.
TEST_CASE("constant_sqrt beside squares, their middles and powers of two") {
    std::mt19937_64 bits(20230609);
    differences = 0;
    const auto around = [](double x) {
        double y = std::nextafter(std::nextafter(x, 0.0), 0.0);
        for (int i = 0; i < 5; ++i) {
            compare(y);
            y = std::nextafter(y, limits::infinity());
        }
    };
    for (int i = 0; i < 50'000; ++i) {
        const double n = static_cast<double>(bits() >> 38); // 26 bits: the square is exact
        around(n * n);
        around((n + 0.5) * (n + 0.5));
        const double root = std::bit_cast<double>((bits() >> 12) | 0x3ff0000000000000);
        around(root * root);
        around(root * std::nextafter(root, 2.0));
    }
    for (int e = -1074; e <= 1023; ++e) {
        around(std::ldexp(1.0, e));
    }
    around(limits::min());
    compare(limits::max());
    compare(0.0);
    compare(-0.0);
    compare(limits::infinity());
    CHECK(differences == 0);
    CHECK(std::isnan(constant_sqrt(limits::quiet_NaN())));
    CHECK(std::isnan(constant_sqrt(-limits::denorm_min())));
}

TEST_CASE("every root of a float by way of double is the float root") {
    std::mt19937_64 bits(20230610);
    long different = 0;
    for (int i = 0; i < 300'000; ++i) {
        const float x = std::abs(std::bit_cast<float>(static_cast<std::uint32_t>(bits() >> 32)));
        if (std::isfinite(x)) {
            different += static_cast<float>(constant_sqrt(static_cast<double>(x))) == std::sqrt(x) ? 0 : 1;
        }
    }
    CHECK(different == 0);
}
