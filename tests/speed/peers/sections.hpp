// The results by kind of pair and dimension: as tables, and as results of a comparison.
#pragma once

#include "measure.hpp"

#include <cstdint>

namespace peers {

// The trials of one thing in one dimension, and the scores by trial and entry.
struct section {
    std::string name;      // "balls against boxes, in space"
    std::string file_name; // "boxes-3d"
    std::vector<trial> trials;
    std::vector<std::vector<std::optional<score>>> scores;
};

// every: all of own_entries, not only graze and double's first and last variant. missing: what the build lacks.
[[nodiscard]] std::vector<entry> all_entries(bool every, std::vector<std::string>& missing);

[[nodiscard]] std::vector<section> measure_sections(const std::vector<entry>& entries, std::uint64_t seed,
                                                    std::size_t count, double timing);

// The settings and promises of all entries, in Markdown.
[[nodiscard]] std::string description_of(const std::vector<entry>& entries, const std::vector<std::string>& missing,
                                         std::size_t count, std::uint64_t seed);

// The table of one section, in Markdown: a row for each entry, a column for each trial.
[[nodiscard]] std::string table_of(const section& s, const std::vector<entry>& entries);

// The section in the form that graze-compare's report draws.
[[nodiscard]] compare::results results_of(const section& s, const std::vector<entry>& entries,
                                          const std::string& command, std::uint64_t seed);

} // namespace peers
