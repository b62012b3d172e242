// classify: the exact encounter of two balls, or of a ball and a plane or a wall. Flights as well as balls.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_flights.hpp>
#include <graze/predicate/classify_numbers.hpp>
#include <graze/predicate/classify_walls.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/predicate/compiled.hpp>
#endif
