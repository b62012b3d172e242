// Results whose texts are safe to print on a terminal, whatever names a scene or a file of results contains.
#pragma once

#include "results.hpp"

namespace compare {

// The same results, with every text made printable (see input_error.hpp).
[[nodiscard]] results with_printable_texts(results found);

} // namespace compare
