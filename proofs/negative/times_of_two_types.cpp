// Times of a pair in the plane and of a pair in space have different types, which do not compare.
// expect: (no match for|invalid operands).*<
#include <graze/time/impact_time.hpp>

#ifdef REPAIRED
constexpr int dimensions = 2;
#else
constexpr int dimensions = 3;
#endif
bool first(const graze::impact_time<2>& x, const graze::impact_time<dimensions>& y) { return x < y; }
