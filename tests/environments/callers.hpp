// Predicates called in the middle of a caller's arithmetic, where a number may not have been stored yet.
#pragma once

namespace environments {

struct caller_tally {
    unsigned long asked = 0, different = 0;
};

// Asks with numbers as expressions, and with the same numbers read back from memory.
[[nodiscard]] caller_tally ask_callers();

} // namespace environments
