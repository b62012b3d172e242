// When two things touch first: time_of_impact, an exact time. Flights as well as balls.
#pragma once

#include <graze/time/time_of_flights.hpp>
#include <graze/time/time_of_shapes.hpp>
