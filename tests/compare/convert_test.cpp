// Exact values in other binary formats, compared with the C library for its types and with MPFR's rounding.
#include "exact_access.hpp"
#include "exact_text.hpp"
#include "solve_pairs.hpp"

#include "../../examples/families/random.hpp"

#include <graze/number/adapter/float128.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

using namespace compare;
namespace mp = boost::multiprecision;

namespace {

constexpr int many = 1000;

// Decimals of up to 60 digits, with exponents below a limit.
class decimals {
  public:
    std::string any(int exponents) {
        return std::string(random_.one_in(2) ? "-" : "") + std::to_string(random_.next()) + "." +
               std::to_string(random_.next()) + std::to_string(random_.next()) + "e" +
               std::to_string(random_.in(-exponents, exponents));
    }
    long bits() { return random_.in(2, 400); }

  private:
    families::random random_{3};
};

using mpfr_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;
using bin_float_50 = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
using bin_float_100 = mp::number<mp::cpp_bin_float<100>, mp::et_off>;

// All digits, in hexadecimal.
std::string text_of(mpfr_srcptr x) {
    mpfr_exp_t exponent = 0;
    char* digits = mpfr_get_str(nullptr, &exponent, 16, 0, x, MPFR_RNDN);
    std::string result = std::string(digits) + "@" + std::to_string(exponent);
    mpfr_free_str(digits);
    return result;
}

// The decimal as MPFR reads it to this many bits.
std::string by_mpfr(const std::string& text, long bits) {
    mpfr_t x;
    mpfr_init2(x, bits);
    mpfr_set_str(x, text.c_str(), 10, MPFR_RNDN);
    const std::string result = text_of(x);
    mpfr_clear(x);
    return result;
}

// An exact value that has at most this many bits.
std::string exactly(const exact& value, long bits) {
    mpq_t rational;
    mpq_init(rational);
    REQUIRE(mpq_set_str(rational, value.str().c_str(), 10) == 0);
    mpfr_t x;
    mpfr_init2(x, bits);
    REQUIRE(mpfr_set_q(x, rational, MPFR_RNDN) == 0);
    const std::string result = text_of(x);
    mpfr_clear(x);
    mpq_clear(rational);
    return result;
}

} // namespace

TEST_CASE("built-in types: as the C library reads the text") {
    decimals source;
    for (int i = 0; i < many; ++i) {
        const std::string f = source.any(70), d = source.any(360), l = source.any(5000);
        CAPTURE(f);
        CAPTURE(d);
        CAPTURE(l);
        CHECK(convert<float>(parse_exact(f)) == std::strtof(f.c_str(), nullptr));
        CHECK(convert<double>(parse_exact(d)) == std::strtod(d.c_str(), nullptr));
        CHECK(convert<long double>(parse_exact(l)) == std::strtold(l.c_str(), nullptr));
#if GRAZE_HAS_FLOAT128
        CHECK((convert<__float128>(parse_exact(l)) == strtoflt128(l.c_str(), nullptr)));
#endif
    }
}

TEST_CASE("any binary format, and Boost's types: as MPFR rounds the text") {
    decimals source;
    for (int i = 0; i < many; ++i) {
        const std::string text = source.any(300);
        CAPTURE(text);
        const exact value = parse_exact(text);
        const long bits = source.bits();
        const rounded_value r = round_to(value, {bits, -100'000, 100'000});
        const exact_integer power = exact_integer(1) << static_cast<unsigned long>(std::labs(r.exponent));
        const exact rounded =
            r.exponent >= 0 ? exact(exact_integer(r.significand * power)) : exact(r.significand, power);
        CHECK(exactly(r.negative ? exact(-rounded) : rounded, bits) == by_mpfr(text, bits));
        CHECK(exactly(exact(convert<bin_float_50>(value)), std::numeric_limits<bin_float_50>::digits) ==
              by_mpfr(text, std::numeric_limits<bin_float_50>::digits));
        CHECK(exactly(exact(convert<bin_float_100>(value)), std::numeric_limits<bin_float_100>::digits) ==
              by_mpfr(text, std::numeric_limits<bin_float_100>::digits));
        const mpfr_50 x = convert<mpfr_50>(value);
        REQUIRE(mpfr_get_prec(x.backend().data()) == std::numeric_limits<mpfr_50>::digits);
        CHECK(text_of(x.backend().data()) == by_mpfr(text, std::numeric_limits<mpfr_50>::digits));
    }
}

TEST_CASE("a whole pair") {
    std::vector<exact> numbers;
    for (int i = 1; i <= 12; ++i) {
        numbers.push_back(exact(i % 2 == 0 ? i : -i, 7));
    }
    pair_numbers row{pair_kind::ball_ball, {}};
    for (const exact& x : numbers) {
        row.numbers.push_back(exact_access::view(x));
    }
    const auto pair = convert_pair<float, 2>(row);
    CHECK(pair.valid);
    const auto sevenths = [](int n) { return static_cast<float>(n) / 7.0F; };
    CHECK(pair.a.position[0] == sevenths(-1));
    CHECK(pair.a.position[1] == sevenths(2));
    CHECK(pair.a.velocity[1] == sevenths(4));
    CHECK(pair.a.radius == sevenths(-5));
    CHECK(pair.a.mass == 1.0F);
    CHECK(pair.inverse_a == sevenths(6));
    CHECK(pair.b.position[0] == sevenths(-7));
    CHECK(pair.inverse_b == sevenths(12));
}
