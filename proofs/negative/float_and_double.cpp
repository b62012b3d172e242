// A float beside a double: one error for each call, not a list of candidates.
// expect: both arguments need the same number type and dimension
// errors: 4
#include <graze/graze.hpp>

#ifdef REPAIRED
using number = double;
constexpr int dimensions = 2;
#else
using number = float;
constexpr int dimensions = 3;
#endif
const graze::ball<2> ball{{0, 0}, {1, 0}, 1};
const graze::ball<2, number> other{{4, 0}, {0, 0}, 1};
const graze::plane<2, number> plane{{9, 0}, {1, 0}};
const graze::wall<2, number> wall{{9, -1}, {{{0, 2}}}};
const auto what = graze::classify(ball, other);
const auto inside = graze::overlaps(ball, plane);
const bool meets = (graze::time_of_impact(graze::flight<2>{ball, 0}, wall), true);
const bool touches = (graze::collide(graze::ball<dimensions>{}, ball), true);
