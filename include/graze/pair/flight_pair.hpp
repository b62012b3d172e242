// Flights as integers: one scale each for lengths, velocities and times, a unit of length being one of velocity times
// one of time, so that the formulas of their motion hold as they are.
#pragma once

#include <graze/formula/contact.hpp>
#include <graze/formula/flight_motion.hpp>
#include <graze/pair/pair.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// A pair of kind P, lifted, with the `since` of each of its two things, which a plane and a wall have from the flight.
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

// A flight in integers, its lengths, velocities and times of their own widths.
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
    // Where one of them is then.
    [[nodiscard]] constexpr auto position(const exact_flight<N, X, U, S>& x) const {
        return position_at(x.state.position, x.state.velocity, start() - x.since);
    }
};

// Widths of lengths, velocities and times. Doubles of like exponents: a way then has 122 bits, Δx 124. And all that
// doubles can span: where two pairs are compared, units of time go down to 2^(-1074 - 971), of one's lengths over the
// other's velocities or by themselves; lengths over that times 2^-1074, times over it and velocities as they are.
template <template <int> class Integer, int Length, int Velocity, int Time>
struct flight_widths {
    static constexpr int length = Length, velocity = Velocity, time = Time;
    template <int N>
    using flights = exact_flights<N, Integer<Length>, Integer<Velocity>, Integer<Time>>;
};
using narrow_flights = flight_widths<integer, 122, 61, 60>;
using wide_flights = flight_widths<sparse_integer, 1024 + 1074 + 2045, full_width, 1024 + 2045>;

template <int N>
[[nodiscard]] constexpr bool is_narrow(const timed_inputs<two_balls<N>>& in) noexcept {
    using w = narrow_flights;
    return in.pair.length.width <= w::length && in.pair.velocity.width <= w::velocity && in.since.width <= w::time;
}

// Two settled flights in integers of the widths W.
template <class W, int N>
[[nodiscard]] constexpr auto flights_in(const timed_inputs<two_balls<N>>& in) noexcept {
    using flights = typename W::template flights<N>;
    constexpr std::size_t n = N;
    const auto vector = [](const auto& group, std::size_t from, auto zero) {
        return make_vec<N>(
            [&](int i) { return group.template get<decltype(zero)>(from + static_cast<std::size_t>(i)); });
    };
    const auto one = [&](std::size_t which) {
        decltype(flights::a) x;
        x.state.position = vector(in.pair.length, which * n, decltype(x.state.radius){});
        x.state.velocity = vector(in.pair.velocity, which * n, typename flights::velocity_type{});
        x.state.radius = in.pair.length.template get<decltype(x.state.radius)>(2 * n + which);
        x.since = in.since.template get<decltype(x.since)>(which);
        return x;
    };
    return flights{one(0), one(1)};
}

// f(flights) with two settled flights in the narrower of two kinds of integers that holds them. f returns the same type
// for both.
template <int N, class F>
[[nodiscard]] constexpr auto with_exact_flights(const timed_inputs<two_balls<N>>& in, F f) {
    if (is_narrow(in)) {
        return f(flights_in<narrow_flights>(in));
    }
    return f(flights_in<wide_flights>(in));
}

} // namespace graze::inline v0_1::detail
