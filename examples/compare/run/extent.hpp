// What a run is asked for.
#pragma once

#include "../problem.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace compare::run {

// How far a run goes: until a time, for a number of events, or whichever of both comes first.
// jam: see run_limits.
struct extent {
    std::optional<exact> until;
    std::optional<std::uint64_t> events;
    std::uint64_t jam = 0;
};

// How far a run has come, as in "event 128, t = 3.25 (32%)".
[[nodiscard]] std::string progress_of(const extent& how_far, std::uint64_t events, double time);

// digits: the decimal digits wanted of positions and velocities at the end, counted from the first digit of the largest
// coordinate and of the largest component of a velocity. most_bits: a decision that is still open at this precision is
// reported.
struct certainty {
    int digits = 15;
    long most_bits = 1L << 16U;
};

} // namespace compare::run
