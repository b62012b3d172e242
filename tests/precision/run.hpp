// The work of a precision program: measure, compare, report.
#pragma once

#include <graze/precision/subject.hpp>

#include <string>

namespace precision {

// Returns the exit codes that `usage` lists. flags: those with which the formulas were compiled.
[[nodiscard]] int run(int argc, char** argv, const graze::precision::subjects& formulas, const std::string& compiler,
                      const std::string& flags);

} // namespace precision
