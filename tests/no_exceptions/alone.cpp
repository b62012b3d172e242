// alone: a program without exceptions. Bad input ends it.
#include "questions.hpp"

int main(int argc, char**) {
    return asked_without_exceptions(argc > 1 ? -1 : 3) == graze::encounter::graze && tried_without_exceptions() ? 0 : 1;
}
