// The number types of other libraries that the whole regression measures, those that are there.
#pragma once

#include <graze/number/double_word.hpp>

#ifdef PRECISION_HAS_BOOST
#include <graze/number/boost.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#endif
#ifdef PRECISION_HAS_MPFR
#include <graze/number/mpfr.hpp>
#endif
#ifdef PRECISION_HAS_FLOAT128
#include <graze/number/float128.hpp>
#endif

namespace precision_types {

#ifdef PRECISION_HAS_BOOST
namespace mp = boost::multiprecision;
using cpp_bin_float_50 = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
using cpp_bin_float_100 = mp::number<mp::cpp_bin_float<100>, mp::et_off>;
#endif
#ifdef PRECISION_HAS_MPFR
using mpfr_float_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;
#endif

} // namespace precision_types
