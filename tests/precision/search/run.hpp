// The search: tries one after the other, each kept when it is done.
#pragma once

#include "kept.hpp"

#include <functional>

namespace search {

struct plan {
    std::uint64_t tries = 100;                    // of all shards together
    const std::atomic<bool>* stop = nullptr;      // when it is set, the search ends soon and keeps what it has
    std::function<void(const kept_file&)> saved;  // called whenever something is to be kept
    std::function<void(const std::string&)> told; // a line a try
};

// Goes on from `file`: its tries from file.next on, then, once all are done, those pairs that are still climbing, once
// each. Stopped at any moment and called again with what was saved last, it finds what it would have found unstopped.
// Returns whether all was done.
bool go_on(kept_file& file, const goal& g, const std::vector<precision::family>& families, const plan& p);

// One try alone, with `climbs` times the evaluations, as an origin's command says. Empty where it leads nowhere.
[[nodiscard]] std::optional<found> repeat(const goal& g, const std::vector<precision::family>& families,
                                          const terms& of, std::uint64_t attempt, std::uint64_t climbs,
                                          const std::atomic<bool>* stop = nullptr);

// The first subject of "quantity/variant/type". std::invalid_argument that names those there are.
[[nodiscard]] goal goal_of(const terms& t, const graze::precision::subjects& formulas);

// The families that tries start from. std::invalid_argument for a name that there is none of.
[[nodiscard]] std::vector<precision::family> families_of(const terms& t);

// The program: its exit code is 0 when all was done, 1 when nothing was found, 2 for a wrong option or file, 3 when it
// was stopped.
[[nodiscard]] int run(int argc, char** argv, const graze::precision::subjects& formulas);

} // namespace search
