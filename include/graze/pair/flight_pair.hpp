// Flights as integers: one scale each for lengths, velocities and times, a unit of length being one of velocity times
// one of time, so that the formulas of their motion hold as they are.
#pragma once

#include <graze/formula/contact.hpp>
#include <graze/formula/flight_motion.hpp>
#include <graze/pair/pair.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// Room for a pair of flights. Where two pairs are compared, lengths have up to 1024 + 1074 + 2045 bits: units of time
// go down to 2^(-1074 - 971), from one's lengths over the other's velocities or by themselves. Lengths are over that
// unit times 2^-1074, times over that unit, velocities as they are.
using timed_workspace = workspace_of<24576>;

// A pair of kind P, lifted, with the `since` of each of its two things. A plane or a wall has that of the flight.
template <class P>
struct timed_inputs {
    lifted_inputs<P::lengths, P::velocities, P::normals> pair;
    lifted<2> since;

    // The exponent of the largest unit of time that serves. Zeros have no scale.
    [[nodiscard]] constexpr int unit() const noexcept {
        const int of_lengths = pair.length.exponent - pair.velocity.exponent;
        return since.width == 0         ? of_lengths
               : pair.length.width == 0 ? since.exponent
                                        : std::min(since.exponent, of_lengths);
    }
    // Takes a unit that is not above that.
    constexpr void settle(int exponent) noexcept {
        settle(since, exponent);
        settle(pair.length, exponent + pair.velocity.exponent);
    }
    constexpr void use(workspace& w) noexcept {
        pair.use(w);
        since.room = &w;
    }

  private:
    template <std::size_t K>
    static constexpr void settle(lifted<K>& group, int exponent) noexcept {
        if (group.width != 0) {
            lower(group, exponent);
        }
        group.exponent = exponent;
    }
};

template <class P, class Row, class T>
[[nodiscard]] constexpr timed_inputs<P> lift_timed(const Row& row, const std::array<T, 2>& since) noexcept {
    timed_inputs<P> r{lift_row<P>(row), {}};
    lift(r.since, since.data());
    return r;
}

// A flight in integers; lengths, velocities and times each have a width of their own.
template <int N, class X, class U>
struct exact_ball {
    vec<N, X> position;
    vec<N, U> velocity;
    X radius;
};
template <int N, class X, class U, class S>
struct exact_flight {
    exact_ball<N, X, U> state;
    S since;
};

// Two flights at t0, the instant at which the later one starts.
template <int N, class X, class U, class S>
struct exact_flights {
    using velocity_type = U;
    exact_flight<N, X, U, S> a, b;

    [[nodiscard]] constexpr auto motion() const { return relative_motion_of_flights(a, b); }
    [[nodiscard]] constexpr S start() const { return graze::sign(b.since - a.since) > 0 ? b.since : a.since; }
    // The position of one of them at t0.
    [[nodiscard]] constexpr auto position(const exact_flight<N, X, U, S>& x) const {
        return position_at(x.state.position, x.state.velocity, start() - x.since);
    }
};

template <int N>
using big_flights = exact_flights<N, big_integer, big_integer, big_integer>;

// Two lifted flights.
template <int N>
[[nodiscard]] constexpr big_flights<N> flights_in(const timed_inputs<two_balls<N>>& in) noexcept {
    constexpr std::size_t n = N;
    const auto vector = [](const auto& group, std::size_t from) {
        return make_vec<N>([&](int i) { return group.template get<big_integer>(from + static_cast<std::size_t>(i)); });
    };
    const auto one = [&](std::size_t which) {
        return exact_flight<N, big_integer, big_integer, big_integer>{
            {vector(in.pair.length, which * n), vector(in.pair.velocity, which * n),
             in.pair.length.template get<big_integer>(2 * n + which)},
            in.since.template get<big_integer>(which)};
    };
    return {one(0), one(1)};
}

// f(flights) with two lifted flights.
template <int N, class F>
[[nodiscard]] constexpr auto with_exact_flights(timed_inputs<two_balls<N>> in, F f) {
    timed_workspace room;
    in.use(room);
    return f(flights_in(in));
}

} // namespace graze::inline v0_1::detail
