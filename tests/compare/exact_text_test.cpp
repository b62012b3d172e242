// Numbers as text, and exact values to doubles and back, compared with the C library's strtod, which rounds correctly.
#include "exact_text.hpp"
#include "rounding.hpp"

#include "../../examples/families/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace exact_text_test {

using namespace compare;

namespace {

exact ratio(long n, long d) { return exact(n, d); }

std::string message_for(const std::string& text) {
    try {
        static_cast<void>(parse_exact(text));
    } catch (const number_text_error& error) {
        return error.what();
    }
    return "no error";
}

bool same(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }

bool rounds_as_strtod(const std::string& text) {
    return same(nearest_double(parse_exact(text)), std::strtod(text.c_str(), nullptr));
}

std::string digits(families::random& random, int least, int most) {
    std::string text(static_cast<std::size_t>(random.in(least, most)), '0');
    for (char& digit : text) {
        digit = static_cast<char>('0' + random.below(10));
    }
    return text;
}

std::string number_in(families::random& random, int low, int high) { return std::to_string(random.in(low, high)); }

double any_finite(families::random& random) {
    for (;;) {
        const double x = std::bit_cast<double>(random.next());
        if (std::isfinite(x)) {
            return x == 0 ? 0.0 : x; // exact numbers have no negative zero
        }
    }
}

constexpr int many = 5000;

} // namespace

TEST_CASE("decimals, hexadecimal floats and fractions are read exactly") {
    CHECK(parse_exact("0") == 0);
    CHECK(parse_exact("-12") == -12);
    CHECK(parse_exact("+7") == 7);
    CHECK(parse_exact("0.1") == ratio(1, 10));
    CHECK(parse_exact(".5") == ratio(1, 2));
    CHECK(parse_exact("5.") == 5);
    CHECK(parse_exact("-1.25e-2") == ratio(-1, 80));
    CHECK(parse_exact("6.02E+3") == 6020);
    CHECK(parse_exact("007e1") == 70);
    CHECK(parse_exact("-0.0") == 0);
    CHECK(parse_exact("1/3") == ratio(1, 3));
    CHECK(parse_exact("-010/30") == ratio(-1, 3));
    CHECK(parse_exact("0x1.8p-3") == ratio(3, 16));
    CHECK(parse_exact("-0X.8P1") == -1);
    CHECK(parse_exact("0xff") == 255);
    CHECK(parse_exact("0x1p-1074") == exact_of(std::bit_cast<double>(std::uint64_t{1})));
    CHECK(parse_exact("123456789012345678901234567890") == exact(exact_integer("123456789012345678901234567890")));
}

TEST_CASE("what is no number says so") {
    CHECK(message_for("") == "\"\" is empty where a number is expected");
    for (const char* text :
         {"nan", "x", "1 ", " 1", "1.2.3", "--1", "1e5x", "0x", "0x.p1", "1,5", "0b1", ".", "-", "1_000"}) {
        CAPTURE(text);
        CHECK(message_for(text) == '"' + std::string(text) + "\" is not a number");
    }
    CHECK(message_for("1e") == "\"1e\" has no digit in its exponent");
    CHECK(message_for("0x1p") == "\"0x1p\" has no digit in its exponent");
    CHECK(message_for("1/0") == "\"1/0\" has the denominator 0");
    CHECK(message_for("1/") == "\"1/\" is not a fraction of two integers");
    CHECK(message_for("1/-3") == "\"1/-3\" is not a fraction of two integers");
    CHECK(message_for("1/2.5") == "\"1/2.5\" is not a fraction of two integers");
    CHECK(message_for("inf") == "\"inf\" is infinite");
    CHECK(message_for("-Infinity") == "\"-Infinity\" is infinite");
    CHECK(message_for("1e999999999") == "\"1e999999999\" has an exponent beyond ±10000");
    CHECK(message_for("1e-99999999999999999999999") == "\"1e-99999999999999999999999\" has an exponent beyond ±10000");
    CHECK(message_for("0x1p999999999") == "\"0x1p999999999\" has an exponent beyond ±40000");
    CHECK(message_for(std::string(10'001, '1')) ==
          "\"" + std::string(60, '1') + "...\" has more than 10000 characters");
    CHECK(message_for("1\n") == "\"1\\x0a\" is not a number");
    CHECK(parse_exact("1e10000") > 0);
}

TEST_CASE("infinities are recognised") {
    for (const char* text : {"inf", "Inf", "+inf", "Infinity", "INFINITY"}) {
        CHECK(is_infinity(text));
    }
    for (const char* text : {"-inf", "infinit", "", "+", "in f", "1"}) {
        CHECK_FALSE(is_infinity(text));
    }
}

TEST_CASE("rounding to double is that of strtod") {
    for (const char* text : {"9007199254740993",
                             "9007199254740992.5",
                             "9007199254740995",
                             "1e308",
                             "1.7976931348623158e308",
                             "1.797693134862315708145274237317043567980705675e308",
                             "1.797693134862315808e308",
                             "1e309",
                             "4.9e-324",
                             "2.4703282292062327e-324",
                             "2.4703282292062328e-324",
                             "1e-400",
                             "2.2250738585072011e-308",
                             "2.2250738585072014e-308",
                             "-1e309",
                             "-1e-400",
                             "0x1.fffffffffffff7ffffp+1023",
                             "0x1.fffffffffffff8p+1023",
                             "0x0.8p-1074",
                             "0x0.80000001p-1074",
                             "0x1.00000000000008p0",
                             "0x1.00000000000018p0",
                             "0x1.000000000000080001p0"}) {
        CAPTURE(text);
        const double expected = std::strtod(text, nullptr);
        const double found = nearest_double(parse_exact(text));
        CHECK((expected == 0 ? found == 0 : same(found, expected)));
    }
    families::random random(1);
    for (int i = 0; i < many; ++i) {
        const std::string decimal =
            digits(random, 1, 25) + "." + digits(random, 0, 25) + "e" + number_in(random, -345, 320);
        const std::string hexadecimal =
            "0x" + digits(random, 1, 20) + "." + digits(random, 0, 20) + "p" + number_in(random, -1160, 1030);
        CAPTURE(decimal);
        CAPTURE(hexadecimal);
        CHECK(rounds_as_strtod(decimal));
        CHECK(rounds_as_strtod(hexadecimal));
    }
}

TEST_CASE("doubles are held exactly, and the middle of two neighbours goes to the even one") {
    families::random random(2);
    for (int i = 0; i < many; ++i) {
        const double x = any_finite(random);
        const double y = std::nextafter(x, random.one_in(2) ? HUGE_VAL : -HUGE_VAL);
        CAPTURE(x);
        CHECK(same(nearest_double(exact_of(x)), x));
        CHECK(same(double_below(exact_of(x)), x));
        CHECK(same(double_above(exact_of(x)), x));
        if (!std::isfinite(y) || x == 0 || y == 0) {
            continue;
        }
        const exact middle = (exact_of(x) + exact_of(y)) / 2;
        const bool x_is_even = std::bit_cast<std::uint64_t>(x) % 2 == 0;
        CHECK(same(nearest_double(middle), x_is_even ? x : y));
        CHECK(same(double_below(middle), std::min(x, y)));
        CHECK(same(double_above(middle), std::max(x, y)));
        const exact nearer_y = middle + (exact_of(y) - exact_of(x)) / exact(exact_integer(1) << 200U);
        CHECK(same(nearest_double(nearer_y), y));
    }
    const exact huge = parse_exact("1e400");
    CHECK(nearest_double(huge) == HUGE_VAL);
    CHECK(double_below(huge) == DBL_MAX);
    CHECK(double_above(huge) == HUGE_VAL);
    CHECK(double_below(exact(-huge)) == -HUGE_VAL);
    CHECK(double_above(exact(-huge)) == -DBL_MAX);
    CHECK_THROWS_AS(static_cast<void>(exact_of(HUGE_VAL)), std::domain_error);
    CHECK_THROWS_AS(static_cast<void>(exact_of(std::nan(""))), std::domain_error);
}

} // namespace exact_text_test
