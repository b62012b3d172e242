// The number-type-generic solver, for every pair.
#pragma once

#include <graze/formula/solve_balls.hpp>
#include <graze/formula/solve_plane.hpp>
#include <graze/formula/solve_wall.hpp>
