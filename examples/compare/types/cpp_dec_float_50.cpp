#include "../measure.hpp"
#include "types.hpp"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <string>

namespace compare {

using cpp_dec_float_50 =
    boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

namespace {

wide power_of_ten(unsigned long exponent) {
    return wide(boost::multiprecision::pow(exact_integer(10), static_cast<unsigned>(exponent)));
}

} // namespace

// Good to more than the 50 digits, of which it holds about 80; a decimal quotient is not correctly rounded.
template <>
struct converter<cpp_dec_float_50> {
    [[nodiscard]] static cpp_dec_float_50 from(const exact& x) {
        return cpp_dec_float_50(exact_integer(numerator(x)).str()) /
               cpp_dec_float_50(exact_integer(denominator(x)).str());
    }
};

template <>
struct reader<cpp_dec_float_50> {
    // All digits that it holds, more than 50, as text; then an integer times or over a power of ten, rounded once.
    [[nodiscard]] static computed read(const cpp_dec_float_50& x, const true_value&) {
        if (!isfinite(x)) {
            return not_finite{};
        }
        std::string text = x.str(1000, std::ios::scientific);
        const auto letter = text.find('e');
        long exponent = std::stol(text.substr(letter + 1));
        text.resize(letter);
        if (const auto point = text.find('.'); point != std::string::npos) {
            text.erase(point, 1);
            exponent -= static_cast<long>(text.size() - point);
        }
        const bool negative = text.front() == '-';
        const auto first = text.find_first_not_of("-0");
        if (first == std::string::npos) {
            return wide(0);
        }
        const wide digits(exact_integer(text.substr(first)));
        const auto places = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
        const wide size = exponent < 0 ? wide(digits / power_of_ten(places)) : wide(digits * power_of_ten(places));
        return negative ? wide(-size) : size;
    }
};

namespace types {

measurable of_cpp_dec_float_50() { return measurable_type<cpp_dec_float_50>("Boost", false, "decimal"); }

} // namespace types
} // namespace compare
