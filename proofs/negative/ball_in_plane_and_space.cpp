// A disc and a sphere.
// expect: no matching function for call to 'classify
#include <graze/predicate/classify_balls.hpp>

#ifdef REPAIRED
constexpr int dimensions = 2;
#else
constexpr int dimensions = 3;
#endif
constexpr auto what = graze::classify(graze::ball<2>{{0, 0}, {1, 0}, 1}, graze::ball<dimensions>{{5, 0}, {0, 0}, 1});
