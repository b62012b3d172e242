// The number-type-generic solver, for every pair: solve, in the built-in types and whatever has number_traits.
#pragma once

#include <graze/formula/solve_balls.hpp>
#include <graze/formula/solve_plane.hpp>
#include <graze/formula/solve_wall.hpp>
#include <graze/number/floating.hpp>
