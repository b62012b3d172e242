// One block of pairs of every family, decided by the library and by the oracle.
#pragma once

#include "more_families.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soak {

// All families of the examples and of the tests.
inline constexpr auto families_drawn = [] {
    std::array<families::family, families::all_families.size() + families::more_families.size()> all{};
    std::size_t n = 0;
    for (const auto& f : families::all_families) {
        all[n++] = f;
    }
    for (const auto& f : families::more_families) {
        all[n++] = f;
    }
    return all;
}();

// The counts of one family in one dimension.
struct tally {
    std::uint64_t pairs = 0, exact = 0, wrong = 0;
    std::uint64_t hard = 0; // pairs that the filter left open
    std::array<std::uint64_t, 5> encounters{};
    std::uint64_t orders = 0, exact_orders = 0, ties = 0, wrong_orders = 0;

    tally& operator+=(const tally& other);
};

// Element i belongs to families_drawn[i].
using tallies = std::array<tally, families_drawn.size()>;

// What is drawn: all pairs, or only the walls in space, each replaced by the triangle that is its half.
enum class drawn { all, triangles };

// Draws pairs first to first + count - 1 of every family in N dimensions. Compares classify, overlaps, time_of_impact,
// the order of times and their order against doubles with the oracle. Describes each pair decided wrongly in
// `complaints`.
template <int N>
void run_block(drawn what, std::uint64_t seed, std::uint64_t first, std::uint64_t count, tallies& seen,
               std::vector<std::string>& complaints);

extern template void run_block<2>(drawn, std::uint64_t, std::uint64_t, std::uint64_t, tallies&,
                                  std::vector<std::string>&);
extern template void run_block<3>(drawn, std::uint64_t, std::uint64_t, std::uint64_t, tallies&,
                                  std::vector<std::string>&);

} // namespace soak
