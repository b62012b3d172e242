// Four dimensions.
// expect: graze::vec: N is 2 or 3
#include <graze/linear/vec.hpp>

#ifdef REPAIRED
constexpr int dimensions = 3;
#else
constexpr int dimensions = 4;
#endif
constexpr graze::vec<dimensions, double> x{};
