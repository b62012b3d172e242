#include "exact_text.hpp"

#include "input_error.hpp"
#include "rounding.hpp"

#include <algorithm>
#include <string>

namespace compare {

namespace {

constexpr std::size_t longest_text = 10'000;
constexpr long largest_decimal_exponent = 10'000;
constexpr long largest_binary_exponent = 40'000;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_digit(char c, bool hexadecimal) {
    return (c >= '0' && c <= '9') || (hexadecimal && lower(c) >= 'a' && lower(c) <= 'f');
}

// Reads the text from the left, piece by piece.
class scanner {
  public:
    explicit scanner(std::string_view text) : text_(text), rest_(text) {}

    [[nodiscard]] bool done() const { return rest_.empty(); }

    bool take(char c) {
        if (rest_.empty() || lower(rest_.front()) != c) {
            return false;
        }
        rest_.remove_prefix(1);
        return true;
    }

    bool take_sign() { // true if it is a minus
        if (take('-')) {
            return true;
        }
        take('+');
        return false;
    }

    std::string_view take_digits(bool hexadecimal = false) {
        std::size_t length = 0;
        while (length < rest_.size() && is_digit(rest_[length], hexadecimal)) {
            ++length;
        }
        const std::string_view digits = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return digits;
    }

    // The exponent that follows its letter; throws if it is beyond ±largest.
    long take_exponent(long largest) {
        const bool negative = take_sign();
        const std::string_view digits = take_digits();
        if (digits.empty()) {
            fail("has no digit in its exponent");
        }
        long exponent = 0;
        for (const char digit : digits) {
            exponent = std::min(exponent * 10 + (digit - '0'), largest + 1);
        }
        if (exponent > largest) {
            fail("has an exponent beyond ±" + std::to_string(largest));
        }
        return negative ? -exponent : exponent;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw number_text_error('"' + printable(std::string(text_)) + "\" " + what);
    }

  private:
    std::string_view text_, rest_;
};

exact_integer integer_of(std::string_view digits, bool hexadecimal = false) {
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size())); // a leading 0 would mean octal
    if (digits.empty()) {
        return 0;
    }
    return exact_integer((hexadecimal ? "0x" : "") + std::string(digits));
}

exact scaled(const exact_integer& value, const exact_integer& power, bool divide) {
    return divide ? exact(value, power) : exact(exact_integer(value * power));
}

} // namespace

exact parse_exact(std::string_view text) {
    scanner scan(text);
    if (text.empty()) {
        scan.fail("is empty where a number is expected");
    }
    if (text.size() > longest_text) {
        scan.fail("has more than " + std::to_string(longest_text) + " characters");
    }
    if (is_infinity(text) || (text.front() == '-' && is_infinity(text.substr(1)))) {
        scan.fail("is infinite");
    }
    const bool negative = scan.take_sign();
    std::string_view whole = scan.take_digits();
    const bool hexadecimal = whole == "0" && scan.take('x');
    if (hexadecimal) {
        whole = scan.take_digits(true);
    }
    exact value;
    if (!hexadecimal && !whole.empty() && scan.take('/')) {
        const std::string_view below = scan.take_digits();
        if (below.empty() || !scan.done()) {
            scan.fail("is not a fraction of two integers");
        }
        const exact_integer divisor = integer_of(below);
        if (divisor.is_zero()) {
            scan.fail("has the denominator 0");
        }
        value = exact(integer_of(whole), divisor);
    } else {
        const std::string_view fraction = scan.take('.') ? scan.take_digits(hexadecimal) : std::string_view{};
        if (whole.empty() && fraction.empty()) {
            scan.fail("is not a number");
        }
        const exact_integer significand = integer_of(std::string(whole) + std::string(fraction), hexadecimal);
        long exponent = 0;
        if (scan.take(hexadecimal ? 'p' : 'e')) {
            exponent = scan.take_exponent(hexadecimal ? largest_binary_exponent : largest_decimal_exponent);
        }
        if (!scan.done()) {
            scan.fail("is not a number");
        }
        exponent -= static_cast<long>(fraction.size()) * (hexadecimal ? 4 : 1);
        const auto size = static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
        const exact_integer power =
            hexadecimal ? exact_integer(exact_integer(1) << size) : exact_integer(pow(exact_integer(10), size));
        value = scaled(significand, power, exponent < 0);
    }
    return negative ? exact(-value) : value;
}

bool is_infinity(std::string_view text) {
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    std::string word(text);
    std::transform(word.begin(), word.end(), word.begin(), lower);
    return word == "inf" || word == "infinity";
}

} // namespace compare
