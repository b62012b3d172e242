// Where and how things meet and leave: every number correctly rounded.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_walls.hpp>
