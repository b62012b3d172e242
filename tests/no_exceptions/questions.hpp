// The same questions, asked by a unit with exceptions and by one without.
#pragma once

#include <graze/graze.hpp>

// The radius is bad if it is negative.
graze::encounter asked_with_exceptions(double radius);
graze::encounter asked_without_exceptions(double radius);

// Whether all try_ procedures give the right answers.
bool tried_with_exceptions();
bool tried_without_exceptions();
