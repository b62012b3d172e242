// The search: one try after the other, each saved when it is done.
#pragma once

#include "figures.hpp"

#include <functional>

namespace search {

struct plan {
    std::uint64_t tries = 100;                    // of all shards together
    const std::atomic<bool>* stop = nullptr;      // when it is set, the search ends soon and keeps what it has
    std::function<void(const kept_file&)> saved;  // called whenever something is to be kept
    std::function<void(const std::string&)> told; // a line a try
};

// Goes on from `file`: its tries from file.next on; if all were done, those of the pairs still climbing that did so the
// fewest times, once each. Stopped at any moment and called again with what was saved last until it returns true, for
// all was done, it finds what it would have found unstopped.
bool go_on(kept_file& file, const goal& g, const std::vector<precision::family>& families, const plan& p);

// One try alone, with `climbs` times the evaluations, as an origin's command says. Empty where it leads nowhere.
[[nodiscard]] std::optional<found> repeat(const goal& g, const std::vector<precision::family>& families,
                                          const terms& of, std::uint64_t attempt, std::uint64_t climbs,
                                          const std::atomic<bool>* stop = nullptr);

} // namespace search
