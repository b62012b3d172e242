// Ctrl-C ends a run, not the program: what has been found by then is reported.
#pragma once

namespace compare::run {

// From here on an interrupt from the terminal, or a request to terminate, is noted. A second one ends the program.
void note_interruptions();

[[nodiscard]] bool interrupted() noexcept;

} // namespace compare::run
