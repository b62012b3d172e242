#include "questions.hpp"

#if defined(__cpp_exceptions)
#define ASKED asked_with_exceptions
#else
#define ASKED asked_without_exceptions
#endif

graze::encounter ASKED(double radius) {
    const graze::ball<3> a{{-8, 5, 0}, {1, 0, 0}, radius};
    const graze::ball<3> b{{0, 0, 0}, {0, 0, 0}, 2};
    return graze::classify(a, b); // at a distance of 3 + 2: with radius 3 they graze, which takes integers
}
