// What a search makes large.
#pragma once

#include "../inputs.hpp"
#include "../measure.hpp"

#include <graze/precision/subject.hpp>

#include <optional>
#include <string>

namespace search {

using precision::any_pair;

enum class aim {
    error,    // the largest error of a quantity, in units in the last place of the type
    nearest,  // a wrong decision of two balls, as near as can be to the border where the decision changes
    farthest, // the same as far from it as can be
    fallback, // the most work for an answer
};

[[nodiscard]] const char* to_string(aim a) noexcept;
// std::invalid_argument for another word.
[[nodiscard]] aim aim_from(const std::string& word);

// Work done by the calling thread since it started: basic blocks entered in code that was compiled with
// -fsanitize-coverage=trace-pc. The same in every run, whatever else the machine does.
[[nodiscard]] unsigned long long work_done() noexcept;

// formula: of the subjects, the one whose work or answers are searched. of: quantity of the error.
struct goal {
    aim what = aim::error;
    precision::quantity of{};
    const graze::precision::subject* formula = nullptr;

    // Larger is worse for the formula. Empty outside the domain: pairs that the type does not hold, or that the formula
    // is not about. For wrong decisions: -log2 (nearest) or log2 (farthest) of the distance from the border, found
    // pairs above those decided right, whose score leads towards the border.
    [[nodiscard]] std::optional<double> score(const any_pair& p) const;
    // Whether the score is what is sought, and not only on the way to it.
    [[nodiscard]] bool is_found(double score) const;
    // "3.2 units in the last place", "wrong at 1.1e-17 from the border", "5312 basic blocks".
    [[nodiscard]] std::string tell(double score) const;
};

// How far the decision of two balls is from the border to the encounter that was given instead, between 0 and 1: for
// hit and miss |D|/(h² + |a c|), for overlapping |c|/(|Δx|² + R²), for receding |h|/(|Δx| |Δu|). std::nullopt if the
// encounters are the same, or the pair stands on the border.
[[nodiscard]] std::optional<double> distance_from_border(const any_pair& p, graze::encounter given);

} // namespace search
