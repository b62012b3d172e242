// The number types of other libraries that the whole regression measures, if they are installed.
#pragma once

#include <graze/number/double_word.hpp>

#ifdef PRECISION_HAS_BOOST
#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#endif
#ifdef PRECISION_HAS_MPFR
#include <graze/number/adapter/mpfr.hpp>
#endif
#ifdef PRECISION_HAS_FLOAT128
#include <graze/number/adapter/float128.hpp>
#endif
#ifdef PRECISION_HAS_QD
#include <graze/number/adapter/qd.hpp>
#endif
#include <graze/precision/number_access.hpp>

namespace precision_types {

#ifdef PRECISION_HAS_BOOST
namespace mp = boost::multiprecision;
using cpp_bin_float_50 = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
using cpp_bin_float_100 = mp::number<mp::cpp_bin_float<100>, mp::et_off>;
using cpp_dec_float_50 = mp::number<mp::cpp_dec_float<50>, mp::et_off>;
#endif
#ifdef PRECISION_HAS_MPFR
using mpfr_float_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;
#endif

} // namespace precision_types

#ifdef PRECISION_HAS_BOOST
// It promises 50 digits, which give the unit of its errors, and keeps up to 80. Many doubles have more digits: Boost's
// conversion rounds them in its own way, and the truth is about the result.
template <>
struct graze::precision::number_access<precision_types::cpp_dec_float_50> {
    using type = precision_types::cpp_dec_float_50;
    [[nodiscard]] static type from(double x) { return type(x); }

    // All digits, from the text: an integer times a power of ten.
    [[nodiscard]] static reading read(const type& x) {
        if (!isfinite(x)) {
            return {{std::numeric_limits<double>::infinity()}};
        }
        constexpr int more_than_it_keeps = 150;
        std::string text = x.str(more_than_it_keeps, std::ios_base::scientific);
        const auto letter = text.find('e'), point = text.find('.');
        reading r;
        r.decimal_exponent = std::stoi(text.substr(letter + 1));
        text.erase(letter);
        if (point != std::string::npos) {
            r.decimal_exponent -= static_cast<int>(letter - point - 1);
            text.erase(point, 1);
        }
        while (text.back() == '0' && text.size() > 1) {
            text.pop_back();
            ++r.decimal_exponent;
        }
        const bool negative = text.front() == '-';
        boost::multiprecision::cpp_int rest(text.substr(std::min(text.find_first_not_of("-+0"), text.size() - 1)));
        for (int bits = 0; rest != 0 || r.parts.empty(); bits += 53, rest >>= 53) {
            const double part = std::ldexp(static_cast<double>(rest & ((std::int64_t{1} << 53) - 1)), bits);
            r.parts.push_back(negative ? -part : part);
        }
        return r;
    }
};
#endif

#ifdef PRECISION_HAS_QD
// Sums of doubles, which hold every double.
template <>
struct graze::precision::number_access<dd_real> {
    [[nodiscard]] static dd_real from(double x) { return dd_real(x); }
    [[nodiscard]] static reading read(const dd_real& x) { return {{x.x[0], x.x[1]}}; }
};
template <>
struct graze::precision::number_access<qd_real> {
    [[nodiscard]] static qd_real from(double x) { return qd_real(x); }
    [[nodiscard]] static reading read(const qd_real& x) { return {{x.x[0], x.x[1], x.x[2], x.x[3]}}; }
};
#endif
