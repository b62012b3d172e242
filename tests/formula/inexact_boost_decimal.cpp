#include "inexact.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_dec_float.hpp>

namespace mp = boost::multiprecision;
using cpp_dec_float_50 = mp::number<mp::cpp_dec_float<50>, mp::et_off>;

namespace inexact {

// It truncates, so a rounding loses a whole unit in the last promised digit. (It keeps a few more digits.)
template <>
struct rounding<cpp_dec_float_50> {
    static double unit() { return 1e-49; }
    static constexpr bool sums_by_operands = false;
};

// From its decimal text, which is exact with as many digits as it keeps.
template <>
mpq_class exact_value(cpp_dec_float_50 x) {
    std::string text = x.str(std::numeric_limits<cpp_dec_float_50>::max_digits10, std::ios_base::scientific);
    const auto e = text.find('e');
    const long exponent = std::stol(text.substr(e + 1));
    text.resize(e);
    const auto dot = text.find('.');
    const long places = dot == text.npos ? 0 : static_cast<long>(text.size() - dot - 1);
    if (dot != text.npos) {
        text.erase(dot, 1);
    }
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent - places)));
    const mpz_class digits(text[0] == '+' ? text.substr(1) : text, 10);
    mpq_class value = exponent < places ? mpq_class(digits, power) : mpq_class(digits * power);
    value.canonicalize();
    return value;
}

} // namespace inexact

TEST_CASE("graze::solve in cpp_dec_float_50 errs within its bound") { inexact::check_all<cpp_dec_float_50>(100); }
