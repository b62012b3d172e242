// An event's time rounded by doubles alone, where that leaves no doubt.
#pragma once

#include <graze/exact/rounding.hpp>
#include <graze/machine/fused.hpp>
#include <graze/time/bounded_time.hpp>
#include <graze/time/fast_approach.hpp>
#include <graze/time/flat_time.hpp>

#include <optional>
#include <type_traits>

namespace graze::inline v0_1::detail {

// A positive number rounded to nearest, downward or upward; empty where its bounds leave a doubt, which for directed
// modes they always do of floats.
template <class T>
[[nodiscard]] inline std::optional<T> rounded_without_doubt(const bounded<double>& x, rounding mode) noexcept {
    if (mode == rounding::nearest) {
        const ends<double> interval = ends_of<T>(x);
        return agree<T>(interval) ? std::optional<T>(static_cast<T>(interval.upper)) : std::nullopt;
    }
    if constexpr (std::is_same_v<T, double>) {
        // The number is r + rest ± error, r the nearest double: on the side of r that the sign of rest tells.
        const auto [r, rest] = two_sum(x.high, x.low);
        if (r > 0x1p-900 && absolute(rest) > x.error) {
            const std::uint64_t bits = bits_of(r);
            const bool above = rest > 0;
            return mode == rounding::downward ? std::bit_cast<double>(above ? bits : bits - 1)
                                              : std::bit_cast<double>(above ? bits + 1 : bits);
        }
    }
    return std::nullopt;
}

// When two balls meet that do so near `time`; nothing is known unless good.
template <int N, class U>
struct time_by_doubles {
    const U* row;
    double time;

    struct answer {
        bounded<double> time;
        bool good;
    };
    using pair = two_balls<N>;
    template <bool Fused>
    [[nodiscard, gnu::always_inline]] answer operator()(std::bool_constant<Fused>) const noexcept {
        const auto r = approach_near<Fused>(
            lane_motion_of<N>(row, row + N, row + pair::lengths, row + pair::lengths + N, row[2 * N], row[2 * N + 1]),
            time);
        return {r.time(), r.good};
    }
};

// The time of a hit on a plane or a wall. Not inlined, so that the time of balls is.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] std::optional<T> round_fast_hit(const event<N, U>& e, double time,
                                                             rounding mode) noexcept {
    if (time > 0) {
        if (const flat_time near = with_best_products(flat_time_near<N, U>{&e, time}); near.good) [[likely]] {
            if (const auto rounded = rounded_without_doubt<T>(near.bounds(), mode)) [[likely]] {
                return rounded;
            }
        }
    }
    const bounded<double> found = as_bounds(hit_time(e));
    return absolute(found.high) > 0x1p-500 ? rounded_without_doubt<T>(found, mode) : std::nullopt;
}

// Whether doubles are tried at all: the inputs are doubles or numbers that doubles hold exactly.
template <class U>
inline constexpr bool is_rounded_by_doubles = has_error_free_doubles && !std::is_same_v<U, std::int64_t>;

// time: near that of the event, which is not an overlap.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] std::optional<T> round_fast(const event<N, U>& e, double time, rounding mode) noexcept {
    if constexpr (is_rounded_by_doubles<U>) {
        if (e.kind == event_kind::balls && rounds_to_nearest()) {
            const auto found = with_best_products(time_by_doubles<N, U>{e.row.data(), time});
            if (found.good) {
                return rounded_without_doubt<T>(found.time, mode);
            }
        } else if (e.kind != event_kind::balls && rounds_to_nearest()) {
            return round_fast_hit<T>(e, time, mode);
        }
    }
    return std::nullopt;
}

} // namespace graze::inline v0_1::detail
