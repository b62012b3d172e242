// An event's time rounded by doubles alone, if they leave no doubt.
#pragma once

#include <graze/exact/rounding.hpp>
#include <graze/machine/fused.hpp>
#include <graze/time/close_approach.hpp>
#include <graze/time/flat_time.hpp>
#include <graze/time/hit_time.hpp>
#include <graze/time/mover_approach.hpp>
#include <graze/time/scaled_rounding.hpp>

#include <type_traits>

namespace graze::inline v0_1::detail {

// When two balls meet near `time`, from their row.
template <int N, class U>
struct time_of_row {
    const U* row;
    double time;

    using pair = two_balls<N>;
    [[nodiscard, gnu::always_inline]] lane_motion motion() const noexcept {
        return lane_motion_of<N>(row, row + N, row + pair::lengths, row + pair::lengths + N, row[2 * N],
                                 row[2 * N + 1]);
    }
    template <bool Fused>
    [[nodiscard, gnu::always_inline]] time_in_doubles operator()(std::bool_constant<Fused>) const noexcept {
        const auto r = approach_near<Fused, N>(motion(), time);
        return {r.time(), r.good};
    }
};

// The same where `time` may be far off: by where the balls are closest, or by where they start if their way is short.
template <int N, class U>
struct hard_time_of_row : time_of_row<N, U> {
    template <bool Fused>
    [[nodiscard, gnu::always_inline]] time_in_doubles operator()(std::bool_constant<Fused>) const noexcept {
        const lane_motion m = this->motion();
        const double length2 = squared_length(m);
        const lanes squares = m.u01.value * m.u01.value + m.u_2.value * m.u_2.value;
        if (is_distant(m.xR2.value[0], length2)) {
            const decided_approach r = approach_from_afar<Fused, N>(m, length2);
            return {r.time(), r.is_hit()};
        }
        if (is_close((squares[0] + squares[1]) * (this->time * this->time), length2)) {
            const decided_approach r = approach_from_near<Fused>(m, length2);
            return {r.time(), r.is_hit()};
        }
        const auto r = approach_near<Fused, N>(m, this->time, length2);
        return {r.time(), r.good};
    }
};

// Whether doubles are tried at all: the inputs are doubles, or numbers that doubles hold exactly.
template <class U>
inline constexpr bool is_rounded_by_doubles = has_error_free_doubles && !std::is_same_v<U, std::int64_t>;

// The time of two balls near `near`, rounded, if doubles leave no doubt.
template <class T, int N, class U>
[[nodiscard]] certain_number<T> round_balls_in_doubles(const event_row<N, U>& e, double near, rounding mode) noexcept {
    if (rounds_to_nearest()) {
        if (const auto found = with_best_products(time_of_row<N, U>{e.row.data(), near}); found.good) {
            return certainly_rounded<T>(found.time, mode);
        }
    }
    return {};
}

// Whether a time is known so well that its rounding is seldom in doubt: at most once in 2^9.
[[nodiscard]] inline bool is_close_enough(const bounded<double>& x) noexcept {
    return x.error < 0x1p-63 * absolute(x.high);
}

// The time of a hit on a plane or a wall: by one step from a double that is near it, or by the formulas in words.
template <int N, class U>
[[nodiscard]] approached_time approach_flat(const event_row<N, U>& e, double near) noexcept {
    if constexpr (is_rounded_by_doubles<U>) {
        if (rounds_to_nearest()) {
            const auto start = static_cast<double>(e.start());
            const double time = e.timed ? near - start : near;
            const auto found = [&](const bounded<double>& x) {
                return approached_time{e.timed ? on_clock(start, x) : x, 0, true};
            };
            if (time > 0) {
                const flat_time stepped = flat_time_in_doubles(e, time);
                if (stepped.good && is_close_enough(stepped.bounds())) [[likely]] {
                    return found(stepped.bounds());
                }
            }
            const bounded<double> t = as_bounds(hit_time(e));
            if (absolute(t.high) > 0x1p-500) {
                return found(t);
            }
        }
    }
    return {};
}

} // namespace graze::inline v0_1::detail
