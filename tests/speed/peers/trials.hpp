// The questions by family, the same in every run with the same seed.
#pragma once

#include "question.hpp"

#include <cstddef>
#include <cstdint>

namespace peers {

// All trials, of `count` questions each: balls in space and in the plane, boxes in space and in the plane, edges in the
// plane. Pairs that overlap at the start or are at relative rest are left out, except those that part.
[[nodiscard]] std::vector<trial> all_trials(std::uint64_t seed, std::size_t count);

// Balls in space that graze, are far apart or almost touch, from easy to hard.
[[nodiscard]] std::vector<trial> trials_by_hardness(std::uint64_t seed, std::size_t count);

} // namespace peers
