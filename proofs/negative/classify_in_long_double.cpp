// An inexact type for which there is no proven filter.
// expect: graze::classify decides exactly, for float, double, std::int32_t, std::int64_t and exact
#include <graze/number/floating.hpp>
#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_numbers.hpp>

#ifdef REPAIRED
using number = double;
#else
using number = long double;
#endif
const graze::ball<2, number> b{{0, 0}, {1, 0}, 1};
const auto what = graze::classify(b, b);
