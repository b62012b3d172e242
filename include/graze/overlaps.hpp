// overlaps: whether two things are inside each other, exactly. Flights as well as balls.
#pragma once

#include <graze/predicate/overlaps_of_flights.hpp>
#include <graze/predicate/overlaps_of_numbers.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/predicate/compiled.hpp>
#endif
