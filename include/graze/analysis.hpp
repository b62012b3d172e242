// Numbers that speak of a formula: its error, its width, its cost, its terms.
#pragma once

#include <graze/analysis/bit_width.hpp>
#include <graze/analysis/error_bound.hpp>
#include <graze/analysis/gappa_term.hpp>
#include <graze/analysis/operation_count.hpp>
#include <graze/analysis/polynomial.hpp>
#include <graze/analysis/range_bound.hpp>
#include <graze/analysis/rational_function.hpp>
#include <graze/analysis/rounding_count.hpp>
