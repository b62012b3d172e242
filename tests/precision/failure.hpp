// The report of a failure.
#pragma once

#include "accepted.hpp"

namespace precision {

// How this program was made and asked, for messages.
struct circumstances {
    std::string program, compiler, flags;
    std::string inputs_option, accepted_option; // by which inputs and accepted figures are named again
    std::filesystem::path results;              // where shrunk inputs and scenes are written
    std::string as_variant;                     // whose accepted figures are compared with; empty: the formula's own
};

// What is worse than accepted; empty if nothing is. For figures that promise to be correctly rounded, what is wrong at
// all.
[[nodiscard]] std::vector<std::string> losses(const figures& now, const figures& accepted);

// "none" where there are no flags.
[[nodiscard]] std::string flags_or_none(const std::string& flags);

// The message, with the smallest input found that shows the loss and that an accepted build (see reference.hpp) has
// right, or less wrong by half; it is also written to files.
[[nodiscard]] std::string tell(const key& k, const figures& now, const figures& accepted, const subject& formula,
                               const family& pairs, const circumstances& about);

} // namespace precision
