// A number type that can be measured, and the plan of a measurement.
#pragma once

#include "group.hpp"
#include "results.hpp"
#include "score.hpp"

#include <graze/formula/discriminant.hpp>
#include <graze/formula/roots.hpp>

#include <cstddef>
#include <memory>
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
    double timing_seconds = 0.5;  // the same for its times; aimed at, not kept by types that take milliseconds a pair;
                                  // 0: nothing is timed
    bool every_pair = false;      // no limit on scoring
};

// Solves the pairs of one group, converted to its number type beforehand, by each of its methods.
class solver {
  public:
    virtual ~solver() = default;
    [[nodiscard]] virtual std::vector<method> methods() const = 0;
    // Solves the first `count` pairs by methods()[how] and forgets the solutions.
    virtual void run(std::size_t how, std::size_t count) = 0;
    // Solves one and reads the solution. right: what it should be.
    [[nodiscard]] virtual answer answer_to(std::size_t how, std::size_t pair, const truth& right) = 0;
};

// One number type, or another way to solve pairs.
struct measurable {
    type_information information;
    std::unique_ptr<solver> (*prepare)(const group& pairs) = nullptr; // null where the type is another's name
};

// A row for each method of the plan, without the names of type and group.
[[nodiscard]] std::vector<row> measure(const measurable& type, const group& pairs, const measurement_plan& plan);

} // namespace compare
