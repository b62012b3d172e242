// A user's shape whose vectors name their axes differently: the error says what to specialise.
// expect: specialise graze::vector_access
#include <graze/shape/shape_access.hpp>

struct place {
#ifdef REPAIRED
    double x, y, z;
#else
    double X, Y, Z;
#endif
};
struct sphere {
    place position, velocity;
    double radius;
};
const auto read = graze::shape_of(sphere{});
