// Scene files in JSON. Numbers are read exactly as they are written, not as doubles.
//
//   {"dimension": 2, "name": "...", "description": "...", "source": "...",
//    "balls":  [{"position": [x, y], "velocity": [x, y], "radius": r, "mass": m}],
//    "planes": [{"point": [x, y], "normal": [x, y]}],
//    "walls":  [{"corner": [x, y], "edges": [[x, y]]}],
//    "period": [x, y]}
//
// dimension and balls are required. A ball's mass is 1 unless given, and may be "inf". In space vectors have three
// components, and a wall has two edges. A number is a JSON number or a string that parse_exact reads.
#pragma once

#include "input_error.hpp"
#include "number_input.hpp"
#include "problem.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace compare {

struct scene_file {
    std::string name; // the file's "name", or its file name without the extension
    std::string description;
    std::string source;
    std::variant<exact_scene<2>, exact_scene<3>> scene;
};

// Throws input_error. The file is at most 256 MiB; "-" is the standard input.
[[nodiscard]] scene_file read_scene(const std::string& path, number_input numbers = number_input::as_double);

// Reads a scene from text. file: what messages call it.
[[nodiscard]] scene_file read_scene_text(std::string_view text, const std::string& file,
                                         number_input numbers = number_input::as_double);

} // namespace compare
