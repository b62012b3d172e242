// True and computed answers in words and decimals.
#pragma once

#include "score.hpp"

#include <string>

namespace compare {

// "hit", "graze", of a wall "hit of edge 1"; for a type's answer also "undecided" and "no answer".
[[nodiscard]] std::string told_decision(const truth& right);
[[nodiscard]] std::string told_decision(const answer& given);

// In decimals, to more digits than a double has: a number, or a vector in parentheses; two balls have two vectors.
[[nodiscard]] std::string told_value(quantity which, const truth& right);
[[nodiscard]] std::string told_value(quantity which, const answer& given, const truth& right);

// One number. An exact rational is written in lowest terms if that is short.
[[nodiscard]] std::string told_number(const true_value& x);

} // namespace compare
