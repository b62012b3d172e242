#include "../measure.hpp"
#include "types.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <string>

namespace compare {

using cpp_dec_float_50 =
    boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

// Right to more than 50 digits (the type holds about 80). A decimal quotient is not correctly rounded.
template <>
struct converter<cpp_dec_float_50> {
    [[nodiscard]] static cpp_dec_float_50 from(const exact_view& x) {
        return cpp_dec_float_50(x.numerator_in_decimal()) / cpp_dec_float_50(x.denominator_in_decimal());
    }
};

template <>
struct reader<cpp_dec_float_50> {
    // Reads all digits that it holds, which are more than 50, as text.
    static void read(const cpp_dec_float_50& x, const request& asked) {
        if (!isfinite(x)) {
            return asked.to.not_finite();
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
            return asked.to.number({});
        }
        asked.to.decimal(negative, text.substr(first), exponent);
    }
};

namespace types {

measurable of_cpp_dec_float_50() {
    measurable result = measurable_type<cpp_dec_float_50>("Boost", false, "decimal");
    result.takes_long = true;
    return result;
}

} // namespace types
} // namespace compare
