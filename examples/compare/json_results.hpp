// Results as JSON, by the schema of docs/reference/compare-json.md.
#pragma once

#include "results.hpp"

#include <string>

namespace compare {

[[nodiscard]] std::string to_json(const results& found);

// Throws input_error that names the file, the place in it and what is wrong.
[[nodiscard]] results read_results(const std::string& path);

} // namespace compare
