// The search: one try after the other, each saved when it is done.
#pragma once

#include "figures.hpp"

#include <functional>

namespace search {

struct plan {
    std::uint64_t tries = 100;                    // of all shards together
    const std::atomic<bool>* stop = nullptr;      // once set, the search ends soon and keeps what it has
    std::function<void(const kept_file&)> saved;  // called whenever there is something to save
    std::function<void(const std::string&)> told; // gets a line for each try
};

// Continues from `file` with its tries from file.next on. If all tries are made, the pairs that can still climb and did
// so least often climb once more. The search may be stopped at any moment and called again with what was saved last,
// until it returns true (all is done): it then finds what it would have found without the stops.
bool go_on(kept_file& file, const goal& g, const std::vector<precision::family>& families, const plan& p);

// One try alone, with `climbs` times the evaluations, as in an origin's command. Empty if it finds nothing.
[[nodiscard]] std::optional<found> repeat(const goal& g, const std::vector<precision::family>& families,
                                          const terms& of, std::uint64_t attempt, std::uint64_t climbs,
                                          const std::atomic<bool>* stop = nullptr);

} // namespace search
