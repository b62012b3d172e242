// An identity is never proved modulo 2^64: coefficients that don't fit don't compile.
// expect: a coefficient of more than 63 bits
#include <graze/analysis/polynomial.hpp>

constexpr bool holds() {
    graze::polynomial<> x(1 << 30);
#ifndef REPAIRED
    x = x * x;
#endif
    return x * x - x * x == graze::polynomial<>(0);
}
static_assert(holds());
