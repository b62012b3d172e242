// Asking whether an unknown type is exact.
// expect: exact_bits: neither a built-in type nor one that number_traits describes
#include <graze/formula/exact_in.hpp>

struct unknown {};
#ifdef REPAIRED
using number = double;
#else
using number = unknown;
#endif
constexpr bool exact = graze::exact_in<number, 2>(graze::grid{.length = 10, .velocity = 10});
