// Compares contestants with exact arithmetic: decisions, times, nanoseconds.
#pragma once

#include "contestant.hpp"

#include <results.hpp>

#include <cstddef>

namespace peers {

// One contestant on one trial.
struct score {
    std::size_t asked = 0, touch = 0;     // questions, and those of them where the two do touch
    std::size_t missed = 0, invented = 0; // wrong decisions: a touch that is none of its answers, and the reverse
    double largest = 0, median = 0;       // relative error of the time, where it and the truth have one that is not 0
    double nanoseconds = 0;               // lower quartile of the repeats
    compare::row row;                     // the same and more, as the report takes it
};

// In the order of the entries; those that do not take the trial have no value. timing: seconds for all together.
[[nodiscard]] std::vector<std::optional<score>> measure(const trial& t, const std::vector<entry>& entries,
                                                        double timing);

} // namespace peers
