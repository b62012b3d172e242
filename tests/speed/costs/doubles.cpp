#include "in_numbers.hpp"

namespace costs {
contestant in_doubles(const pairs& all) { return all_in<double>(all); }
} // namespace costs
