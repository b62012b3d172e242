// Which stage settles graze's answers, by family.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace peers {

// How many pairs each stage settles; the index is graze::stage.
using stage_counts = std::array<std::size_t, 4>;

struct fallback_rate {
    std::string family;
    int dimension = 0;
    stage_counts decisions{}; // for all pairs
    stage_counts contacts{};  // for two balls that meet: the widest stage that the decision or any component needed
};

[[nodiscard]] std::vector<fallback_rate> fallback_rates(std::uint64_t seed, std::size_t count);

[[nodiscard]] std::string table_of(const std::vector<fallback_rate>& rates); // in Markdown

// Throws compare::report::gnuplot_error.
[[nodiscard]] std::string picture_of(const std::vector<fallback_rate>& rates);

} // namespace peers
