// Results as JSON, by the schema of docs/reference/compare-json.md.
#pragma once

#include "results.hpp"

#include <string>

namespace compare {

[[nodiscard]] std::string to_json(const results& found);

// Throws input_error, which names the file, the place in it and what is wrong.
[[nodiscard]] results read_results(const std::string& path);

// The times in the format of Google Benchmark's --benchmark_format=json, with each repeat of each row, as its
// compare.py reads them.
[[nodiscard]] std::string to_benchmark_json(const results& found);

} // namespace compare
