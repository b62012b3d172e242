// Compares contestants with exact arithmetic: decisions, times, nanoseconds.
#pragma once

#include "contestant.hpp"

#include <results.hpp>

#include <cstddef>

namespace peers {

// The score of one contestant in one trial.
struct score {
    std::size_t asked = 0, touch = 0;     // questions; those in which the two do touch
    std::size_t missed = 0, invented = 0; // wrong decisions: a touch is missed, or invented
    double largest = 0, median = 0;       // relative errors of times, where the truth and the answer are not 0
    double nanoseconds = 0;               // lower quartile of the repeats
    compare::row row;                     // the same and more, for the report
};

// In the order of the entries; empty for those that do not take the trial. timing: seconds for all together.
[[nodiscard]] std::vector<std::optional<score>> measure(const trial& t, const std::vector<entry>& entries,
                                                        double timing);

} // namespace peers
