// The default scene, a pool break, embedded in the program.
#pragma once

#include "default_scene_text.hpp"
#include "pairs.hpp"
#include "scene_reader.hpp"

namespace compare {

// Its pairs, with 2,000 of the family grazing and 2,000 of the family far beside them, as groups of these names.
[[nodiscard]] scene_pairs<2> default_pairs(number_input numbers = number_input::as_double, std::uint64_t seed = 1);

} // namespace compare
