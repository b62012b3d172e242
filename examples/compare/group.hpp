// Pairs that are measured together, with their truth.
#pragma once

#include "progress.hpp"
#include "results.hpp"
#include "truth.hpp"

#include <optional>
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
// encounters, conditions, places. pairs_of is left alone.
template <int N>
[[nodiscard]] group make_group(group_information information, std::vector<problem<N>> problems,
                               const progress_line& line);

// The pair of this number (see pair_information), with all that is told of it; empty if the group does not hold it.
[[nodiscard]] std::optional<pair_information> pair_of(const group& of, std::size_t number);

// Every pair as the precision regression reads it, with the command that shows it.
[[nodiscard]] std::string lines_of_pairs(const std::vector<group>& groups, const std::string& command);

// Fills in what the groups of the results show: the pairs that their rows are at their worst on.
void show_extremes(results& found, const std::vector<group>& groups);

} // namespace compare
