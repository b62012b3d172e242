// From a pair that shows a loss to an easier one that shows it too.
#pragma once

#include "inputs.hpp"

#include <functional>

namespace precision {

// Makes numbers 0, shortens their significands and removes their exponents, as long as `still_shows` returns true,
// until nothing more can be removed or it was called `most` times.
[[nodiscard]] any_pair shrunk(const any_pair& p, const std::function<bool(const any_pair&)>& still_shows,
                              std::size_t most = 2000);

} // namespace precision
