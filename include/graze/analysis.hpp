// Number types in which a formula yields its error bound, its width, its cost or its terms instead of a value.
#pragma once

#include <graze/analysis/bit_width.hpp>
#include <graze/analysis/error_bound.hpp>
#include <graze/analysis/fpcore_term.hpp>
#include <graze/analysis/gappa_term.hpp>
#include <graze/analysis/operation_count.hpp>
#include <graze/analysis/polynomial.hpp>
#include <graze/analysis/range_bound.hpp>
#include <graze/analysis/rational_function.hpp>
#include <graze/analysis/rounding_count.hpp>
