// Kahan's discriminant in a number type without a fused multiply-add.
// expect: has_fma|has_variant
#include "../rational.hpp"

#include <graze/number/floating.hpp>
#include <graze/solve.hpp>

#ifdef REPAIRED
using number = double;
#else
using number = graze::proof::rational;
#endif
const graze::ball<2, number> b{{{0, 0}}, {{1, 0}}, 1, 1};
const auto s = graze::solve<graze::variant::kahan>(b, b);
