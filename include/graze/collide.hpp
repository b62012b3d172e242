// Where and how things meet and leave: collide, every number correctly rounded. Flights as well as balls.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_flights.hpp>
#include <graze/contact/collide_walls.hpp>
