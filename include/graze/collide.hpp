// collide: the contact of a pair, every number correctly rounded. Flights as well as balls.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_flights.hpp>
#include <graze/contact/collide_walls.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/contact/compiled.hpp>
#include <graze/predicate/compiled.hpp>
#include <graze/time/compiled.hpp>
#endif
