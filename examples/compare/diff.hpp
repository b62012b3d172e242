// The differences of two comparisons, row by row, and the history of many.
#pragma once

#include "results.hpp"

#include <string>
#include <vector>

namespace compare {

// A figure that changed. by: how many bits (doublings) it moved; infinite from or to 0 or infinity.
struct change {
    std::string row, what, before, after;
    double by = 0;
};

struct difference {
    std::vector<std::string> other_pairs; // settings by which the pairs are others: nothing can be concluded then
    std::vector<std::string> other_build; // what else differs: compiler, flags, processor, version
    std::vector<change> worse, better;    // from the one that moved most on
    std::vector<change> slower, faster;   // times that differ significantly; they only inform
    std::vector<std::string> only_old, only_new; // rows that the other one lacks
    std::vector<std::string> not_comparable;     // rows measured on different numbers of pairs
    std::size_t same = 0;                        // rows without any change but of time
    std::size_t compared = 0;
    std::size_t times_compared = 0; // of rows
    double common_ratio = 1;        // of the times of all rows, which is the machine's and is left out
    bool old_has_repeats = true;    // else times are compared by their quartiles
};

// Rows are matched by group, type, variant and root. Worse is: more wrong or open decisions, a larger largest or median
// error, fewer correctly rounded values, or less conserved momentum or energy. A time is slower or faster if its median
// and its least repeat, less what all rows have in common, differ by more than 10% and the probability that chance did
// it is below 1% over all times together (Holm 1979).
[[nodiscard]] difference compare_results(const results& before, const results& after);

[[nodiscard]] std::string to_text(const difference& d);

// A row's cost and correct digits over several results, from the earliest on; a value is absent where the row is.
struct row_history {
    std::string group, type, variant, root;
    std::vector<std::optional<double>> nanoseconds, digits;
    std::vector<std::optional<std::size_t>> wrong;
};

// Of the rows that some results have, in the order of the last ones.
[[nodiscard]] std::vector<row_history> history_of(const std::vector<results>& all);

[[nodiscard]] std::string history_text(const std::vector<results>& all, const std::vector<std::string>& names);

} // namespace compare
