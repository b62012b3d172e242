// A plane without a direction in a constant expression.
// expect: normal is zero
#include <graze/predicate/classify_walls.hpp>

#ifdef REPAIRED
constexpr double up = 1;
#else
constexpr double up = 0;
#endif
constexpr auto what = graze::classify(graze::ball<2>{{0, 3}, {0, -1}, 1}, graze::plane<2>{{0, 0}, {0, up}});
