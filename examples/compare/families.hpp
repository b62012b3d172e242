// The hard-case families of examples/families as problems.
#pragma once

#include "../families/families.hpp"
#include "input_error.hpp"
#include "problem.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace compare {

struct family_description {
    std::string name;
    std::string what_makes_it_hard; // one sentence
    bool has_hardness;              // whether its problems carry a k
    std::string hardness_meaning;   // what the k is, or empty
};

[[nodiscard]] std::vector<family_description> family_list();

// The doubles' exact values.
template <int N>
[[nodiscard]] problem<N> to_problem(const families::pair_of_doubles<N>& pair, const std::string& group);

// The first `count` pairs of the family: the same for the same seed on every platform. Throws input_error, which lists
// the families' names, if there is no family of this name.
template <int N>
[[nodiscard]] std::vector<problem<N>> draw_family(const std::string& name, std::size_t count, std::uint64_t seed);

} // namespace compare
