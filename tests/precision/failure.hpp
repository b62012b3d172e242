// The report of a failure.
#pragma once

#include "accepted.hpp"

namespace precision {

// How this program was compiled and called, for messages.
struct circumstances {
    std::string program, compiler, flags;
    std::string inputs_option, accepted_option; // to name inputs and accepted figures in commands
    std::filesystem::path results;              // where to write shrunk inputs and scenes
    std::string as_variant;                     // compare with this variant's figures; empty: the formula's own
};

// What is worse than accepted; empty if nothing is. For figures that promise correct rounding: everything that is
// wrong.
[[nodiscard]] std::vector<std::string> losses(const figures& now, const figures& accepted);

// "none" if there are no flags.
[[nodiscard]] std::string flags_or_none(const std::string& flags);

// The message, with the smallest input found that shows the loss and that an accepted build (see reference.hpp) gets
// right or at most half as wrong. The input is also written to files.
[[nodiscard]] std::string tell(const key& k, const figures& now, const figures& accepted, const subject& formula,
                               const family& pairs, const circumstances& about);

} // namespace precision
