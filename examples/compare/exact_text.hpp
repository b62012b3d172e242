// From the text of a number to its exact value.
#pragma once

#include "problem.hpp"

#include <stdexcept>
#include <string_view>

namespace compare {

// Thrown for a text that is no number, or one too large to be held exactly. what() says what is wrong, but not where.
class number_text_error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The exact value of a decimal (-12, 0.1, 6.02e23), a hexadecimal float (0x1.8p-3) or a fraction of integers (1/3).
// Throws number_text_error for anything else. To bound the memory that a text can take, it also throws for more than
// 10,000 characters, a decimal exponent beyond ±10,000 or a binary one beyond ±40,000.
[[nodiscard]] exact parse_exact(std::string_view text);

// Whether text is inf or Infinity, in any case, with or without a +. A mass may be that instead of a number.
[[nodiscard]] bool is_infinity(std::string_view text);

} // namespace compare
