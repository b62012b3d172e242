// A number type that lacks an operation: τ is a quotient, and integers have no quotients.
// expect: field_number
#include <graze/exact/integer.hpp>
#include <graze/number/floating.hpp>
#include <graze/solve.hpp>

#ifdef REPAIRED
using number = double;
#else
using number = graze::integer<20>;
#endif
template <class T>
auto solved() {
    const graze::ball<2, T> b{{{T(0), T(0)}}, {{T(1), T(0)}}, T(1)};
    return graze::solve(b, b);
}
auto s = solved<number>();
