#include "in_numbers.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace costs {
contestant in_digits(const pairs& all) { return all_in<boost::multiprecision::cpp_bin_float_50>(all); }
} // namespace costs
