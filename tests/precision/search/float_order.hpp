// Doubles as integers in the same order: neighbours differ by one; -0 and +0 are both 0.
#pragma once

#include <bit>
#include <cstdint>

namespace search {

[[nodiscard]] constexpr std::int64_t place_of(double x) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto magnitude = static_cast<std::int64_t>(bits & ~sign);
    return (bits & sign) != 0 ? -magnitude : magnitude;
}

[[nodiscard]] constexpr double at_place(std::int64_t place) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    return std::bit_cast<double>(place < 0 ? static_cast<std::uint64_t>(-place) | sign
                                           : static_cast<std::uint64_t>(place));
}

// The place of the largest finite double.
inline constexpr std::int64_t last_place = 0x7fefffffffffffff;

} // namespace search
