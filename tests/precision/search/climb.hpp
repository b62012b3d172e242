// One try: narrows a box of inputs to its worst part, then climbs, bit by bit, to a pair that no change of a bit makes
// worse.
#pragma once

#include "goal.hpp"

#include <atomic>
#include <cstdint>

namespace search {

struct found {
    any_pair pair;
    double score = 0;
    bool climbing = false;              // it could go on: it was stopped, or its budget was used up
    std::optional<any_pair> other = {}; // for an order, the second pair

    [[nodiscard]] std::optional<double> score_by(const goal& g) const {
        return g.score(pair, other ? &*other : nullptr);
    }
    // One or two lines of a file.
    [[nodiscard]] std::string lines() const {
        return precision::to_line(pair) + (other ? "\n" + precision::to_line(*other) : "");
    }
};

struct allowance {
    std::uint64_t evaluations = 20'000; // of the goal, in one try
    const std::atomic<bool>* stop = nullptr;

    [[nodiscard]] bool spent() const { return evaluations == 0 || (stop != nullptr && stop->load()); }
};

// The start of try number `index` of a seed: a pair of a family, with ranges around its numbers, from a few neighbours
// to everything between 2^-64 and 2^64, in the order of the floats. The ranges are halved in turn; the half in which a
// few samples score higher is kept. Empty if no sample was in the goal's domain.
[[nodiscard]] std::optional<found> descend(const goal& g, const std::vector<precision::family>& families,
                                           std::uint64_t seed, std::uint64_t index, allowance& left);

// Changes one number at a time: each of its bits, its neighbours, its sign, 0, another of the numbers. Ends when none
// of these changes makes the pair worse, or the allowance is used up.
void climb(const goal& g, found& at, allowance& left);

// Simpler numbers whose score is at least `share` of f's (for wrong decisions: at most one bit less extreme).
[[nodiscard]] found shrink(const goal& g, const found& f, double share = 0.95);

} // namespace search
