// How often the filter leaves an answer to integers, by family.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace peers {

struct fallback_rate {
    std::string family;
    int dimension = 0;
    std::size_t pairs = 0, decided_exactly = 0;     // of all pairs: by integers
    std::size_t contacts = 0, contacts_exactly = 0; // of two balls that meet: integers decided or rounded something
};

[[nodiscard]] std::vector<fallback_rate> fallback_rates(std::uint64_t seed, std::size_t count);

[[nodiscard]] std::string table_of(const std::vector<fallback_rate>& rates); // in Markdown

// Throws compare::report::gnuplot_error.
[[nodiscard]] std::string picture_of(const std::vector<fallback_rate>& rates);

} // namespace peers
