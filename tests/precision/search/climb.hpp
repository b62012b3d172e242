// One try: it narrows a box of inputs to its worst part, then climbs, bit by bit, to a pair that no changed bit makes
// worse.
#pragma once

#include "goal.hpp"

#include <atomic>
#include <cstdint>

namespace search {

struct found {
    any_pair pair;
    double score = 0;
    bool climbing = false; // still: it stopped on its budget, or was stopped, and not because nothing was worse
    std::optional<any_pair> other = {}; // of an order, the second pair

    [[nodiscard]] std::optional<double> score_by(const goal& g) const {
        return g.score(pair, other ? &*other : nullptr);
    }
    // Lines of a file, one or two.
    [[nodiscard]] std::string lines() const {
        return precision::to_line(pair) + (other ? "\n" + precision::to_line(*other) : "");
    }
};

struct allowance {
    std::uint64_t evaluations = 20'000; // of the goal, for one try
    const std::atomic<bool>* stop = nullptr;

    [[nodiscard]] bool spent() const { return evaluations == 0 || (stop != nullptr && stop->load()); }
};

// Where try number `index` of a seed starts: a pair of a family, and ranges about it, from a few neighbours to
// everything between 2^-64 and 2^64, in the order of the floats. Ranges are halved in turn; of the two halves the one
// of which a few samples score higher is kept. Empty where nothing was in the goal's domain.
[[nodiscard]] std::optional<found> descend(const goal& g, const std::vector<precision::family>& families,
                                           std::uint64_t seed, std::uint64_t index, allowance& left);

// Changes one number at a time: each of its bits, its neighbours, its sign, 0, another of the numbers. Ends where none
// of all these changes is worse, or where nothing is left.
void climb(const goal& g, found& at, allowance& left);

// Simpler numbers that score at least `share` of it (for wrong decisions: that are at most one bit less extreme).
[[nodiscard]] found shrink(const goal& g, const found& f, double share = 0.95);

} // namespace search
