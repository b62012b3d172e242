// A number type that can be measured, and what a measurement is asked to do.
#pragma once

#include "group.hpp"
#include "results.hpp"

#include <graze/formula/discriminant.hpp>
#include <graze/formula/roots.hpp>

#include <vector>

namespace compare {

// A variant of the formulas.
struct method {
    graze::variant variant;
    graze::root_form root;
    friend bool operator==(const method&, const method&) = default;
};

[[nodiscard]] const char* to_string(graze::variant v) noexcept;
[[nodiscard]] const char* to_string(graze::root_form f) noexcept;
[[nodiscard]] std::vector<method> all_methods();

struct measurement_plan {
    std::vector<method> methods;  // measured where the type can run them
    double scoring_seconds = 2.0; // for all methods of a type in a group; an exact type that takes longer stops early
    double timing_seconds = 0.5;  // the same for its times; aimed at, not kept by types that take milliseconds a pair
    bool every_pair = false;      // no limit on scoring
};

// One number type. measure appends the rows of a group, without the names of type and group.
struct measurable {
    type_information information;
    void (*measure)(const group& pairs, const measurement_plan& plan, std::vector<row>& rows) = nullptr;
};

} // namespace compare
