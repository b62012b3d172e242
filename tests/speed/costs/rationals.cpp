#include "in_numbers.hpp"

#include <graze/number/adapter/gmp.hpp>

namespace costs {
contestant in_rationals(const pairs& all) { return decisions_in<graze::gmp_rational>(all); }
} // namespace costs
