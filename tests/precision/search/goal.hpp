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
    nearest,  // a wrong decision, as near as can be to the border where it would be right
    farthest, // the same as far from it as can be
    fallback, // the most work for an answer
};

[[nodiscard]] const char* to_string(aim a) noexcept;
// std::invalid_argument for another word.
[[nodiscard]] aim aim_from(const std::string& word);

// Work done by the calling thread since it started: basic blocks entered in code that was compiled with
// -fsanitize-coverage=trace-pc. The same in every run, whatever else the machine does.
[[nodiscard]] unsigned long long work_done() noexcept;

// How large the numbers of a pair may be that are not 0, so that a search finds realistic cases and not underflow.
struct magnitudes {
    struct range {
        double low = 0, high = std::numeric_limits<double>::infinity();
        [[nodiscard]] bool holds(double x) const { return x == 0 || (std::fabs(x) >= low && std::fabs(x) <= high); }
    };
    range lengths, velocities, masses; // positions, radii, points, corners and edges are lengths; normals are free

    // Of each number, in the order of the files.
    [[nodiscard]] std::vector<range> of(const any_pair& p) const;
};

// "1e-3:1e3", the least and the greatest. std::invalid_argument that names the option.
[[nodiscard]] magnitudes::range range_from(const std::string& option, const std::string& text);

// formulas: the subjects of one figure, of which one is asked about a pair: the first that is about it. of: quantity of
// the error; of an order, which is asked about two pairs, its decision.
struct goal {
    aim what = aim::error;
    precision::quantity of{};
    std::vector<const graze::precision::subject*> formulas;
    magnitudes within = {};

    // Larger is worse for the formula. Empty outside the domain: pairs that the type does not hold, that are not within
    // the magnitudes, or that the formula is not about. For wrong decisions: -log2 (nearest) or log2 (farthest) of the
    // relative distance from the border (border.hpp), found pairs above those decided right, whose score leads towards
    // the border. Last of those found are the wrong ones on the border itself, and where what promises to be right
    // throws.
    // other: of an order, the second pair. Its border is where both times are one; the distance is that of the times,
    // by the later one.
    [[nodiscard]] std::optional<double> score(const any_pair& p, const any_pair* other = nullptr) const;
    [[nodiscard]] bool is_about_orders() const { return of == precision::quantity::order; }
    // Whether the score is that of a find, not only of a pair on the way to one.
    [[nodiscard]] bool is_found(double score) const;
    // "3.2 units in the last place", "wrong at 1.1e-17 from the border", "5312 basic blocks".
    [[nodiscard]] std::string tell(double score) const;
};

} // namespace search
