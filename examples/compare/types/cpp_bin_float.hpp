// Boost's cpp_bin_float.
#pragma once

#include "../reader.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace compare {

template <unsigned Digits>
using cpp_bin_float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

} // namespace compare
