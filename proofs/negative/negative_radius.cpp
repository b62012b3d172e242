// A ball of radius -1 in a constant expression. The compiler shows the call that names the ball and the field.
// expect: radius is negative
#include <graze/predicate/classify_balls.hpp>

#ifdef REPAIRED
constexpr double radius = 1;
#else
constexpr double radius = -1;
#endif
constexpr auto what = graze::classify(graze::ball<2>{{0, 0}, {1, 0}, radius}, graze::ball<2>{{5, 0}, {0, 0}, 1});
