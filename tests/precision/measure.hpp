// Measures every formula on every family: the figures that are compared with the accepted ones.
#pragma once

#include "inputs.hpp"
#include "judge.hpp"

#include <compare>
#include <functional>

namespace precision {

// Identifies figures: `quantity/variant/type/family` in messages and in --only.
struct key {
    quantity of{};
    std::string variant, type, family;
    friend auto operator<=>(const key&, const key&) = default;
};
[[nodiscard]] std::string to_string(const key& k);

struct figures {
    std::size_t pairs = 0, wrong = 0;       // judged; those with a wrong decision, a wrong sign, or no answer
    std::size_t values = 0, misrounded = 0; // numbers; those that are not the type's nearest
    double largest = 0, median = 0;         // error in units in the last place
    bool correctly_rounded = false;         // promised: then wrong and misrounded must be 0

    // In the family: the first wrong pair, the pair with the largest error, and the first misrounded pair.
    std::optional<std::size_t> wrong_at, largest_at, misrounded_at;
};

using all_figures = std::map<key, figures>;

// What to measure. Left out: families whose name `chooses` refuses, and formulas all of whose keys it refuses.
struct plan {
    std::vector<family> families;
    std::function<bool(const key&)> chooses = [](const key&) { return true; };
    unsigned threads = 1;
};

// Throws std::runtime_error if two number types, or two formulas about the same pairs, share a name and so their
// figures.
[[nodiscard]] all_figures measure(const graze::precision::subjects& formulas, const plan& what);

// Judges one pair (for an order, two) as the type holds it. Nothing if the type cannot hold the pair or the formula is
// not about it.
[[nodiscard]] std::optional<verdict> judge_one(const subject& formula, quantity of, const any_pair& p,
                                               const any_pair* other = nullptr);

// The pair with its numbers as the type holds them, if it is then valid. No pair of doubles is what a decimal type
// holds: only the truth knows that.
template <int N>
[[nodiscard]] std::optional<pair<N>> held(const pair<N>& p, const graze::precision::number_type& type);

// The truth about the pair as it is held.
template <int N>
[[nodiscard]] std::optional<truth<N>> truth_for(const pair<N>& p, const graze::precision::number_type& type);

} // namespace precision
