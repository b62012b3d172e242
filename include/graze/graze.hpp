// The library for pairs. Scenes (graze/scene.hpp), runs (graze/run.hpp) and adapters for other libraries' number types
// (graze/number/adapter/boost.hpp, gmp.hpp, ...) are included by name.
#pragma once

#include <graze/classify.hpp>
#include <graze/collide.hpp>
#include <graze/overlaps.hpp>
#include <graze/own_types.hpp>
#include <graze/solve.hpp>
#include <graze/time_of_impact.hpp>
