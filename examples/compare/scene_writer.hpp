// A pair as numbers to read and as a scene file.
#pragma once

#include "problem.hpp"
#include "results.hpp"

#include <string>
#include <vector>

namespace compare {

// The pair's numbers, the components of a vector together: "a position", "a velocity", "a radius", "a mass", then those
// of b, of the plane or of the wall.
[[nodiscard]] std::vector<named_number> numbers_of_pair(const problem<2>& pair);
[[nodiscard]] std::vector<named_number> numbers_of_pair(const problem<3>& pair);

// A scene file with this pair alone, which is read as the same numbers.
[[nodiscard]] std::string scene_of_pair(const problem<2>& pair, const std::string& name);
[[nodiscard]] std::string scene_of_pair(const problem<3>& pair, const std::string& name);

// The pair as a line of the precision regression's input (tests/precision/inputs.hpp), each number as the nearest
// double.
[[nodiscard]] std::string line_of_pair(const problem<2>& pair);
[[nodiscard]] std::string line_of_pair(const problem<3>& pair);

} // namespace compare
