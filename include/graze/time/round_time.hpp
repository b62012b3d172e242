// An event's exact time, rounded.
#pragma once

#include <graze/time/enclosure.hpp>
#include <graze/time/further_time.hpp>
#include <graze/time/round_exactly.hpp>
#include <graze/time/round_in_doubles.hpp>

namespace graze::inline v0_1::detail {

// A mover of an event of two movers.
template <moving B, int N, class U>
[[nodiscard]] constexpr B mover_in(const event_row<N, U>& e, std::size_t which) noexcept {
    if constexpr (is_flight<B>) {
        return {mover_in<ball<N, U>>(e, which), e.since(two_balls<N>{})[which]};
    } else {
        B b;
        for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
            b.position[static_cast<int>(i)] = e.row[which * N + i];
            b.velocity[static_cast<int>(i)] = e.row[two_balls<N>::lengths + which * N + i];
        }
        b.radius = e.row[2 * N + which];
        return b;
    }
}

// An event's time, near a double, rounded: by words and integers.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] constexpr T round_slowly(const event<N, U>& e, double near, rounding mode) {
    if (!std::is_constant_evaluated()) {
        if (const auto rounded = round_approached<T>(e.procedures->approach(e, near), mode)) {
            return *rounded;
        }
    }
    if constexpr (std::is_integral_v<U>) { // always exact, and often short
        if (const auto rounded = round_narrow<T>(e, mode)) {
            return *rounded;
        }
    }
    timed_workspace room;
    return round_exactly<T>(e.procedures->root(e, room), mode);
}

// The time of two balls that do not overlap, near `time`, rounded to nearest: by doubles if that leaves no doubt.
//
// Only the rounding direction of the environment matters if the inputs become doubles as they are. Where subnormals are
// read or written as zeros, an operation loses at most 2^-1022, and R and t0 times that (below 2^201 each) go into |y|²
// - R²: less than 2^-700, while the error that is allowed for is at least 2^-99 (|Δx|² + R²) > 2^-299. A result that
// these bounds leave in no doubt is no subnormal double; a subnormal float is compared with zero, and is in doubt where
// it is read as zero. An input that is a subnormal float, up to 2^-126, must not be read as zero.
template <class T, int N, class U, class Step = time_of_row<N, U>>
struct nearest_time {
    const event<N, U>* e;
    double time;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] T operator()(std::bool_constant<Fused> fused) const {
        const auto found = Step{e->row.data(), time}(fused);
        const ends<double> interval = ends_of<T>(found.time);
        const bool to_nearest = std::is_same_v<U, float> ? rounds_to_nearest() : adds_to_nearest();
        if (all_hold(found.good, agree<T>(interval), to_nearest)) [[likely]] {
            return static_cast<T>(interval.upper);
        }
        return round_slowly<T>(*e, time, rounding::nearest);
    }
};

// The same where `time` may be far off.
template <class T, int N, class U>
[[nodiscard, gnu::noinline]] T round_hard_time(const event<N, U>& e, double time) {
    const T nearest = with_fused_products(nearest_time<T, N, U, hard_time_of_row<N, U>>{&e, time}, T(-1));
    return nearest < 0 ? round_slowly<T>(e, time, rounding::nearest) : nearest; // balls don't touch before 0
}

// The time of two movers by doubles and double words.
template <bool Timed, int N, class U>
[[nodiscard]] approached_time approach_movers(const event_row<N, U>& e) noexcept {
    if constexpr (std::is_floating_point_v<U>) {
        using mover = std::conditional_t<Timed, flight<N, U>, ball<N, U>>;
        return find_further_time(mover_in<mover>(e, 0), mover_in<mover>(e, 1), Timed ? tried::time : tried::step);
    }
    return {};
}

template <int N, class T, class P, bool Timed>
struct procedures_of {
    [[nodiscard, gnu::noinline]] static constexpr exact_root root(const event_row<N, T>& e, workspace& room) {
        return exact_root_of<P, Timed>(e, room);
    }
    [[nodiscard, gnu::noinline]] static approached_time approach(const event_row<N, T>& e,
                                                                 [[maybe_unused]] double near) {
        if constexpr (std::is_same_v<P, two_balls<N>>) {
            return approach_movers<Timed>(e);
        } else {
            return approach_flat(e, near);
        }
    }
    static constexpr event_procedures<N, T> table{root, approach};
};

// A double, rounded.
template <class T>
[[nodiscard]] constexpr T round_double(const double& x, rounding mode) {
    const binary b = to_binary(x);
    if (b.significand == 0) {
        return T(0);
    }
    const leading exact =
        leading_of_words(0, static_cast<std::uint64_t>(b.significand < 0 ? -b.significand : b.significand), b.exponent,
                         b.significand < 0, 0);
    return round_estimate<T>(exact, mode, [](std::uint64_t, int) { return 0; });
}

// The time of an event in the enclosure: if both ends round to the same number, so does the time.
template <class T, rounding Mode, int N, class U>
[[nodiscard, gnu::always_inline]] constexpr inline T round_time(const event<N, U>& e, const enclosure& bounds) {
    if (e.overlap) {
        return static_cast<T>(e.start());
    }
    if (e.nearest && Mode == rounding::nearest) {
        if constexpr (std::is_same_v<T, double>) {
            return bounds.near;
        } else {
            return round_double<T>(bounds.near, Mode);
        }
    }
    if constexpr (std::numeric_limits<T>::digits < 40) { // for doubles the enclosure is hardly ever narrow enough
        const double upper = bounds.upper();
        const T low = round_double<T>(bounds.lower(), Mode);
        if (bits_of(low) == bits_of(round_double<T>(upper, Mode))) {
            return low;
        }
    }
    if constexpr (is_rounded_by_doubles<U>) { // enough for nearly every time
        if (!std::is_constant_evaluated() && e.is_of_balls()) [[likely]] {
            if constexpr (Mode == rounding::nearest) {
                if (bounds.error > 0x1p-36 * bounds.near) [[unlikely]] {
                    return round_hard_time<T>(e, bounds.near);
                }
                return with_best_products(nearest_time<T, N, U>{&e, bounds.near});
            } else if (const auto rounded = round_balls_in_doubles<T>(e, bounds.near, Mode)) {
                return *rounded;
            }
        }
    }
    return round_slowly<T>(e, bounds.near, Mode);
}

} // namespace graze::inline v0_1::detail
