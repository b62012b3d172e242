// Results whose texts are safe to print on a terminal, whatever a scene or a file of results calls itself.
#pragma once

#include "results.hpp"

namespace compare {

// The same results, with every text in them printable (see input_error.hpp).
[[nodiscard]] results with_printable_texts(results found);

} // namespace compare
