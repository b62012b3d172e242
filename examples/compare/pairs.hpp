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

// The pairs of one kind with the same encounter: how many of them were classified, and how many are in the sample.
struct stratum {
    pair_kind kind;
    graze::encounter what;
    std::uint64_t total;
    std::uint64_t taken;
};

template <int N>
struct scene_pairs {
    std::vector<problem<N>> pairs;
    std::vector<stratum> strata;     // those that occur
    std::uint64_t total = 0;         // pairs in the scene
    std::uint64_t classified = 0;    // of them: all, or a part drawn at random of a scene with very many
    std::uint64_t both_infinite = 0; // pairs of two infinite masses: left out, and not part of total
    [[nodiscard]] bool is_sample() const { return pairs.size() < total; }
};

inline constexpr std::size_t sample_size = 2000;
inline constexpr std::size_t every_pair = static_cast<std::size_t>(-1);

// A scene with more pairs is not classified as a whole, which would take long; and not more are measured.
inline constexpr std::uint64_t most_classified = 1'000'000, most_measured = 1'000'000;

// Every pair of the scene if there are at most `largest`. Otherwise about that many, drawn without replacement from
// each stratum: each stratum gets an equal share of `largest`, or all of its pairs, and the rest goes to the larger
// strata. Of a scene with more than most_classified pairs, 400,000 or so are drawn at random first and stand for all.
// The same scene, largest and seed give the same sample on every platform. group is copied into the problems. Throws
// input_error where every pair is wanted of more than most_measured.
template <int N>
[[nodiscard]] scene_pairs<N> pairs_of(const exact_scene<N>& scene, const std::string& group,
                                      std::size_t largest = sample_size, std::uint64_t seed = 1);

// A pair's encounter, decided exactly in integers.
template <int N>
[[nodiscard]] graze::encounter encounter_of_pair(const problem<N>& pair);

} // namespace compare
