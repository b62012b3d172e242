// Two vectors side by side: an inner product is written as one.
// expect: operator ?\*
#include <graze/linear/vec.hpp>
#include <graze/number/floating.hpp>

constexpr graze::vec<2, double> x{{1, 2}};
#ifdef REPAIRED
constexpr auto product = graze::dot(x, x);
#else
constexpr auto product = x * x;
#endif
