// The differences of two comparisons, row by row, and the history of many.
#pragma once

#include "results.hpp"

#include <string>
#include <vector>

namespace compare {

// A figure that changed. by: by how many doublings; infinite from or to 0 or infinity.
struct change {
    std::string row, what, before, after;
    double by = 0;
};

struct difference {
    std::vector<std::string> other_pairs;        // settings that select other pairs: then nothing can be concluded
    std::vector<std::string> other_build;        // what else differs: compiler, flags, processor, version
    std::vector<change> worse, better;           // the largest change first
    std::vector<change> slower, faster;          // times that differ significantly: for information only
    std::vector<std::string> only_old, only_new; // rows that the other one lacks
    std::vector<std::string> not_comparable;     // rows measured on different numbers of pairs
    std::size_t same = 0;                        // rows of which nothing but the time changed
    std::size_t compared = 0;
    std::size_t times_compared = 0; // of rows
    double common_ratio = 1;        // of the times of all rows: due to the machine, and divided out
    bool old_has_repeats = true;    // if not, times are compared by their quartiles
};

// Rows are matched by group, type, variant and root. Worse means more wrong or open decisions, a larger largest or
// median error, fewer correctly rounded values, or momentum or energy conserved less well. A time is slower or faster
// if its median and its least repeat, divided by what all rows have in common, differ by more than 10%, and if the
// probability of that by chance, over all times together, is below 1% (Holm 1979).
[[nodiscard]] difference compare_results(const results& before, const results& after);

[[nodiscard]] std::string to_text(const difference& d);

// A row's cost and correct digits in several results, the earliest first; a value is absent where the row is.
struct row_history {
    std::string group, type, variant, root;
    std::vector<std::optional<double>> nanoseconds, digits;
    std::vector<std::optional<std::size_t>> wrong;
};

// One entry for each row that any of the results has, in the order of the last results.
[[nodiscard]] std::vector<row_history> history_of(const std::vector<results>& all);

[[nodiscard]] std::string history_text(const std::vector<results>& all, const std::vector<std::string>& names);

} // namespace compare
