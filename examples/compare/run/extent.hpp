// What is asked of a run.
#pragma once

#include "../problem.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace compare::run {

// How far a run goes: until a time, for a number of events, or both, whichever is first.
// jam: as that of run_limits.
struct extent {
    std::optional<exact> until;
    std::optional<std::uint64_t> events;
    std::uint64_t jam = 0;
};

// As in "event 128, t = 3.25 (32%)": of a run that has come to there.
[[nodiscard]] std::string progress_of(const extent& how_far, std::uint64_t events, double time);

// What is wanted of the certified run. digits: decimal digits of positions and velocities at the end, counted from the
// first one of the largest coordinate and of the largest component of a velocity. most_bits: the precision after which
// a decision that is still open is reported.
struct certainty {
    int digits = 15;
    long most_bits = 1L << 16U;
};

} // namespace compare::run
