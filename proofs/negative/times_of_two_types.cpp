// The times of a pair in the plane and of one in space are two types.
// expect: (no match for|invalid operands).*<
#include <graze/time/impact_time.hpp>

#ifdef REPAIRED
constexpr int dimensions = 2;
#else
constexpr int dimensions = 3;
#endif
bool first(const graze::impact_time<2>& x, const graze::impact_time<dimensions>& y) { return x < y; }
