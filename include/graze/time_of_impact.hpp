// time_of_impact: the exact time at which two things touch first. Flights as well as balls.
#pragma once

#include <graze/time/time_of_flights.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/predicate/compiled.hpp>
#include <graze/time/compiled.hpp>
#endif
