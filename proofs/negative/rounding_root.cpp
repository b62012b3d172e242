// Exact square roots over a type that rounds.
// expect: sqrt_extension needs an exact number type
#include <graze/exact/integer.hpp>
#include <graze/number/floating.hpp>
#include <graze/number/sqrt_extension.hpp>

#include "../rational.hpp"

#ifdef REPAIRED
using number = graze::proof::rational;
#else
using number = double;
#endif
constexpr graze::sqrt_extension<number> golden(number(1), number(1), number(5));
