// The goal of a search.
#pragma once

#include "../inputs.hpp"
#include "../measure.hpp"

#include <graze/precision/subject.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace search {

using precision::any_pair;

enum class aim {
    error,    // the largest error of a quantity, in units in the last place of the type
    nearest,  // a wrong decision as near as possible to the border where it would be right
    farthest, // the same as far from it as possible
    fallback, // the most work for an answer
};

[[nodiscard]] const char* to_string(aim a) noexcept;
// Throws std::invalid_argument for any other word.
[[nodiscard]] aim aim_from(const std::string& word);

// The work done by the calling thread since it started: basic blocks entered in code compiled with
// -fsanitize-coverage=trace-pc. It is the same in every run, whatever else the machine does.
[[nodiscard]] unsigned long long work_done() noexcept;

// The magnitudes of a pair's numbers that are not 0, so that a search finds realistic cases instead of underflow.
struct magnitudes {
    struct range {
        double low = 0, high = std::numeric_limits<double>::infinity();
        [[nodiscard]] bool holds(double x) const { return x == 0 || (std::fabs(x) >= low && std::fabs(x) <= high); }
    };
    range lengths, velocities, masses; // positions, radii, points, corners and edges are lengths; normals are free

    // The range of each number, in the order of the files.
    [[nodiscard]] std::vector<range> of(const any_pair& p) const;
};

// Reads "1e-3:1e3", the least and the greatest. Throws std::invalid_argument, which names the option.
[[nodiscard]] magnitudes::range range_from(const std::string& option, const std::string& text);

// formulas: the subjects of one figure; the first that is about a pair is asked. of: the quantity whose error counts;
// for an order, which is about two pairs, its decision.
struct goal {
    aim what = aim::error;
    precision::quantity of{};
    std::vector<const graze::precision::subject*> formulas;
    magnitudes within = {};

    // Larger is worse for the formula. Empty outside the domain: for pairs that the type does not hold, that are not
    // within the magnitudes, or that the formula is not about. For wrong decisions it is -log2 (nearest) or log2
    // (farthest) of the relative distance from the border (border.hpp). Pairs decided wrongly score higher than pairs
    // decided correctly, whose scores lead towards the border. Lowest among the wrong ones are those on the border
    // itself, and those where a formula that promises to be right throws. other: for an order, the second pair. Its
    // border is where both times are equal; the distance is the difference of the times over the later one.
    [[nodiscard]] std::optional<double> score(const any_pair& p, const any_pair* other = nullptr) const;
    [[nodiscard]] bool is_about_orders() const { return of == precision::quantity::order; }
    // Whether the score is that of a find, rather than of a pair on the way to one.
    [[nodiscard]] bool is_found(double score) const;
    // "3.2 units in the last place", "wrong at 1.1e-17 from the border", "5312 basic blocks".
    [[nodiscard]] std::string tell(double score) const;
};

} // namespace search
