// Pairs that are measured together, with their truth.
#pragma once

#include "progress.hpp"
#include "results.hpp"
#include "truth.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace compare {

// Ordered so that every initial part holds each kind of pair and of encounter in about its share.
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
// encounters, conditions, places. It does not change information.pairs_of.
template <int N>
[[nodiscard]] group make_group(group_information information, std::vector<problem<N>> problems,
                               const progress_line& line);

// The pair of this number (see pair_information) with all its fields; empty if it is not in the group.
[[nodiscard]] std::optional<pair_information> pair_of(const group& of, std::size_t number);

// Every pair as a line of the precision regression's input, with the command that shows it.
[[nodiscard]] std::string lines_of_pairs(const std::vector<group>& groups, const std::string& command);

// Fills in the pairs on which rows are at their worst.
void show_extremes(results& found, const std::vector<group>& groups);

} // namespace compare
