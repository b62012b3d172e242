// From a pair that shows a loss to a pair that is easier to read and shows it too.
#pragma once

#include "inputs.hpp"

#include <functional>

namespace precision {

// Makes numbers 0, shortens their significands and takes out their exponents, as long as `still_shows` says so, until
// nothing more can be taken away or it was asked `most` times.
[[nodiscard]] any_pair shrunk(const any_pair& p, const std::function<bool(const any_pair&)>& still_shows,
                              std::size_t most = 2000);

} // namespace precision
