// The library for pairs. Scenes and runs (graze/scene/run.hpp, first_events.hpp, ...) and adapters for other libraries'
// number types (graze/number/boost.hpp, gmp.hpp, ...) are included by name.
#pragma once

#include <graze/contact/collide.hpp>
#include <graze/contact/collide_flights.hpp>
#include <graze/formula/solve.hpp>
#include <graze/number/floating.hpp>
#include <graze/predicate/classify_numbers.hpp>
#include <graze/predicate/overlaps_of_flights.hpp>
#include <graze/predicate/time_of_impact.hpp>
