// Pairs that are measured together, with their truth.
#pragma once

#include "progress.hpp"
#include "results.hpp"
#include "truth.hpp"

#include <variant>
#include <vector>

namespace compare {

// In an order in which any first part holds every kind of pair and of encounter in about its share.
template <int N>
struct group_pairs {
    std::vector<problem<N>> problems;
    std::vector<truth> truths;
};

struct group {
    group_information information;
    std::variant<group_pairs<2>, group_pairs<3>> pairs;
};

// Solves the pairs exactly, orders them and fills in what information says of them: dimension, pairs, kinds,
// encounters, conditions. pairs_of is left alone.
template <int N>
[[nodiscard]] group make_group(group_information information, std::vector<problem<N>> problems,
                               const progress_line& line);

} // namespace compare
