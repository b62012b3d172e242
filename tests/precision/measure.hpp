// Measures every formula on every family: the figures that are compared with the accepted ones.
#pragma once

#include "inputs.hpp"
#include "judge.hpp"

#include <compare>
#include <functional>

namespace precision {

// Which figures: `quantity/variant/type/family` in messages and in --only.
struct key {
    quantity of{};
    std::string variant, type, family;
    friend auto operator<=>(const key&, const key&) = default;
};
[[nodiscard]] std::string to_string(const key& k);

struct figures {
    std::size_t pairs = 0, wrong = 0;       // judged; with a wrong decision, a wrong sign, or no answer
    std::size_t values = 0, misrounded = 0; // numbers, and those that are not the nearest of the type
    double largest = 0, median = 0;         // error in units in the last place
    bool correctly_rounded = false;         // promised: wrong and misrounded are 0

    // Of pairs of the family: which one was wrong first, which has the largest error, which was misrounded first.
    std::optional<std::size_t> wrong_at, largest_at, misrounded_at;
};

using all_figures = std::map<key, figures>;

// What is asked. Families whose name `chooses` refuses, and formulas of whose keys it refuses all, are left out.
struct plan {
    std::vector<family> families;
    std::function<bool(const key&)> chooses = [](const key&) { return true; };
    unsigned threads = 1;
};

// Throws std::runtime_error where two number types have one name, or two formulas about the same pairs, and so their
// figures.
[[nodiscard]] all_figures measure(const graze::precision::subjects& formulas, const plan& what);

// One pair (for an order, two), as the type holds it. Nothing where the type holds no such pair or the formula is not
// about it.
[[nodiscard]] std::optional<verdict> judge_one(const subject& formula, quantity of, const any_pair& p,
                                               const any_pair* other = nullptr);

// The pair with its numbers as the type holds them, if they are valid then. A decimal type holds what no pair of
// doubles is: only the truth knows it.
template <int N>
[[nodiscard]] std::optional<pair<N>> held(const pair<N>& p, const graze::precision::number_type& type);

// Of a pair that is held.
template <int N>
[[nodiscard]] std::optional<truth<N>> truth_for(const pair<N>& p, const graze::precision::number_type& type);

} // namespace precision
