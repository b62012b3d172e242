// What connects a user's number type or formula to the precision regression.
#pragma once

#include <graze/precision/decisions.hpp>
#include <graze/precision/formulas.hpp>
