// mixed: a unit with exceptions and a unit without in one program. Bad input to the first throws, whichever unit's code
// was linked; with an argument, bad input to the second ends the program.
#include "questions.hpp"

#include <cstdio>
#include <cstring>
#include <stdexcept>

int main(int argc, char**) {
    bool right = asked_with_exceptions(3) == graze::encounter::graze &&
                 asked_without_exceptions(3) == graze::encounter::graze && tried_with_exceptions() &&
                 tried_without_exceptions();
    try {
        (void)asked_with_exceptions(-1);
        right = false;
    } catch (const std::domain_error& e) {
        right = right && std::strcmp(e.what(), "ball a: radius is negative") == 0;
    }
    std::puts(right ? "right" : "wrong");
    std::fflush(stdout);
    if (argc > 1) {
        (void)asked_without_exceptions(-1);
    }
    return right ? 0 : 1;
}
