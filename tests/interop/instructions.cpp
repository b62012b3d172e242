// One decision about graze's own balls, and one about foreign balls.
#include <graze/own_types.hpp>

struct coordinates {
    double x, y, z;
};
struct particle {
    coordinates position, velocity;
    double radius, mass;
};

extern "C" {
graze::encounter own(const graze::ball<3>& a, const graze::ball<3>& b) { return graze::classify(a, b); }
graze::encounter foreign(const particle& a, const particle& b) { return graze::classify(a, b); }
}
