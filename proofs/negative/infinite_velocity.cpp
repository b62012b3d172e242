// An infinite velocity in a constant expression.
// expect: velocity is not finite
#include <graze/predicate/classify_balls.hpp>

#ifdef REPAIRED
constexpr double speed = 1;
#else
constexpr double speed = std::numeric_limits<double>::infinity();
#endif
constexpr auto what = graze::classify(graze::ball<2>{{0, 0}, {speed, 0}, 1}, graze::ball<2>{{5, 0}, {0, 0}, 1});
