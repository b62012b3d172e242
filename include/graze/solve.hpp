// solve: every pair by the formulas as they are, in the built-in types and every other type that has number_traits.
#pragma once

#include <graze/formula/solve_balls.hpp>
#include <graze/formula/solve_flat.hpp>
#include <graze/formula/solve_plane.hpp>
#include <graze/number/floating.hpp>
