// An exact time against a number, neither of which is rounded.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/machine/fence.hpp>

#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace graze::inline v0_1::detail {

// The types that a time can be compared with: all of their values are doubles or 64-bit integers.
template <class U>
concept time_number = std::same_as<U, float> || std::same_as<U, double> ||
    (std::integral<U> && sizeof(U) <= 8 && (std::signed_integral<U> || sizeof(U) < 8));

// The order of a number and an event's time, which is within the bounds. as_double: whether the number certainly
// converts to double exactly.
template <class Event, class Bounds, class U>
[[nodiscard]] constexpr std::partial_ordering compare_with_number(const Event& event, const Bounds& bounds,
                                                                  const U& time, bool as_double) {
    if (as_double) {
        const auto m = static_cast<double>(as_stored(time));
        if (bounds.upper() < m) {
            return std::partial_ordering::less;
        }
        if (bounds.lower() > m) {
            return std::partial_ordering::greater;
        }
    }
    return compare_exactly(event, to_binary(time)) <=> 0;
}
template <class Event, class Bounds, std::integral U>
[[nodiscard]] constexpr std::partial_ordering compare_with_number(const Event& event, const Bounds& bounds,
                                                                  const U& time) {
    const auto number = static_cast<std::int64_t>(time);
    return compare_with_number(event, bounds, number, number >> 53 == 0);
}
template <class Event, class Bounds, std::floating_point U>
[[nodiscard]] constexpr std::partial_ordering compare_with_number(const Event& event, const Bounds& bounds,
                                                                  const U& time) {
    if (!is_finite_input(time)) {
        return time < 0   ? std::partial_ordering::greater
               : time > 0 ? std::partial_ordering::less
                          : std::partial_ordering::unordered;
    }
    return compare_with_number(event, bounds, time, !is_subnormal(time)); // a mode may read a subnormal as 0
}

} // namespace graze::inline v0_1::detail
