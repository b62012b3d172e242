// The work of a program of graze_add_hard_case_search.
#pragma once

#include <graze/precision/subject.hpp>

#include <string>

namespace search {

// The program, called `name` in origins. Its exit code is 0 if everything was done, 1 if nothing was found, 2 for a
// wrong option or file, 3 if it was stopped.
[[nodiscard]] int run(int argc, char** argv, const graze::precision::subjects& formulas, const std::string& name);

} // namespace search
