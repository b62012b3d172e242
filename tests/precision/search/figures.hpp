// The figures that a search can maximise.
#pragma once

#include "kept.hpp"

namespace search {

// Of subjects of the same variant and type: "quantity/variant/type".
struct figure {
    std::string name;
    precision::quantity of{};
    std::vector<const graze::precision::subject*> formulas;
    bool decides = false; // says what becomes of a pair, at least whether it collides, or which of two comes first
};

// Found by asking each formula about a few pairs of every family.
[[nodiscard]] std::vector<figure> figures_of(const graze::precision::subjects& formulas);

// std::invalid_argument that names the nearest figures there are, or those that the goal is about.
[[nodiscard]] goal goal_of(const terms& t, const graze::precision::subjects& formulas);

// The families that tries start from. std::invalid_argument for an unknown name.
[[nodiscard]] std::vector<precision::family> families_of(const terms& t);

// Of the names, the few that differ from the word in the fewest letters, separated by commas.
[[nodiscard]] std::string nearest_to(const std::string& word, const std::vector<std::string>& names);

} // namespace search
