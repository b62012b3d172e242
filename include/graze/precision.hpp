// How a number type or a formula of one's own meets the precision regression.
#pragma once

#include <graze/precision/decisions.hpp>
#include <graze/precision/formulas.hpp>
