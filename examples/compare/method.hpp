// The names of the formulas' variants, and the plan of a measurement.
#pragma once

#include "solver.hpp"

namespace compare {

[[nodiscard]] const char* to_string(graze::variant v) noexcept;
[[nodiscard]] const char* to_string(graze::root_form f) noexcept;
[[nodiscard]] std::vector<method> all_methods();

struct measurement_plan {
    std::vector<method> methods;  // those that a type cannot run are left out
    double scoring_seconds = 2.0; // for all methods of a type in a group; an exact type that takes longer stops early
    double timing_seconds = 0.5;  // the same for its times; aimed at, not kept by types that take milliseconds a pair;
                                  // 0: nothing is timed
    bool every_pair = false;      // no limit on scoring
};

} // namespace compare
