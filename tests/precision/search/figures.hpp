// The figures that a search can maximise.
#pragma once

#include "kept.hpp"

namespace search {

// The formulas of one variant and type for one quantity: "quantity/variant/type".
struct figure {
    std::string name;
    precision::quantity of{};
    std::vector<const graze::precision::subject*> formulas;
    bool decides = false; // says at least whether a pair collides, or which of two is first
};

// Asks each formula about a few pairs of every family.
[[nodiscard]] std::vector<figure> figures_of(const graze::precision::subjects& formulas);

// Throws std::invalid_argument, which names the nearest existing figures, or those that the goal can be about.
[[nodiscard]] goal goal_of(const terms& t, const graze::precision::subjects& formulas);

// The families that tries start from. Throws std::invalid_argument for an unknown name.
[[nodiscard]] std::vector<precision::family> families_of(const terms& t);

// The few of the names that differ from the word in the fewest letters, separated by commas.
[[nodiscard]] std::string nearest_to(const std::string& word, const std::vector<std::string>& names);

} // namespace search
