// The pairs of a scene, all of them or a sample.
#pragma once

#include "problem.hpp"

#include <graze/formula/encounter.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace compare {

[[nodiscard]] const char* to_string(pair_kind kind) noexcept; // "ball-ball", "ball-plane", "ball-wall"

// The pairs of one kind and encounter: how many were classified, and how many are in the sample.
struct stratum {
    pair_kind kind;
    graze::encounter what;
    std::uint64_t total;
    std::uint64_t taken;
};

template <int N>
struct scene_pairs {
    std::vector<problem<N>> pairs;
    std::vector<stratum> strata;     // those that are not empty
    std::uint64_t total = 0;         // pairs in the scene
    std::uint64_t classified = 0;    // all of them or, in a very large scene, a part drawn at random
    std::uint64_t both_infinite = 0; // pairs of two infinite masses: left out, and not part of total
    [[nodiscard]] bool is_sample() const { return pairs.size() < total; }
};

inline constexpr std::size_t sample_size = 2000;
inline constexpr std::size_t every_pair = static_cast<std::size_t>(-1);

// Classifying more pairs would take too long, so only a part is classified then. No more are measured, either.
inline constexpr std::uint64_t most_classified = 1'000'000, most_measured = 1'000'000;

// Every pair of the scene if there are at most `largest`. Otherwise about that many, drawn without replacement from
// each stratum: each stratum gets an equal share of `largest`, or all of its pairs, and the larger strata share the
// rest. Of a scene with more than most_classified pairs, about 400,000 are first drawn at random and stand for all. The
// same scene, largest and seed give the same sample on every platform. group is copied into the problems. Throws
// input_error if every pair is asked for and there are more than most_measured.
template <int N>
[[nodiscard]] scene_pairs<N> pairs_of(const exact_scene<N>& scene, const std::string& group,
                                      std::size_t largest = sample_size, std::uint64_t seed = 1);

// The pair's encounter, decided exactly in integers.
template <int N>
[[nodiscard]] graze::encounter encounter_of_pair(const problem<N>& pair);

} // namespace compare
