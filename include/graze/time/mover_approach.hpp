// Two movers side by side in lanes, and when they meet near a time in doubles.
//
// u = 2^-53; notation and counting of roundings as in time/newton_approach.hpp.
#pragma once

#include <graze/machine/fused.hpp>
#include <graze/pair/moving.hpp>
#include <graze/time/newton_approach.hpp>

namespace graze::inline v0_1::detail {

// The first two components of a vector.
template <int N, class T>
[[nodiscard, gnu::always_inline]] inline lanes first_two(const vec<N, T>& x) noexcept {
    return lanes{static_cast<double>(as_stored(x[0])), static_cast<double>(as_stored(x[1]))};
}

// The relative motion at the later start, how long before that each started, and |Δx|² + R² or, of flights, 2 (|x_a -
// x_b|² + |u lead|²) + R², which is not less.
//
// Δx is the sum of the doubles x, p and s (the values of x_a - x_b, of u lead and of their sum) and of their errors and
// u times the error of lead, which are at most u |x|, u |p|, u (|x| + |p|) and u |p|. Its error comes from adding these
// up: u² |p|, u² 2|p|, u² (2|p| + |x|), u² (3|p| + 2|x|), at most 8 u² (|x| + |p|): 8.1 u² of the length.
struct lane_movers {
    lane_motion motion;
    double start;
    exact_pair<double> before_a, before_b;
    double length2;
};

// x + u lead.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline exact_pair<lanes>
moved(const exact_pair<lanes>& x, const lanes& u, const exact_pair<double>& lead, double& way2) noexcept {
    const auto way = two_product(as_factor<Fused>(u), as_factor<Fused>(both(lead.value)));
    const auto sum = two_sum(x.value, way.value);
    const lanes squares = x.value * x.value + way.value * way.value;
    way2 += squares[0] + squares[1];
    return two_sum(sum.value, lanes(sum.error + ((way.error + u * lead.error) + x.error)));
}

template <bool Fused, int N, class T>
[[nodiscard, gnu::always_inline]] inline lane_movers lane_movers_of(const ball<N, T>& a, const ball<N, T>& b) noexcept {
    const lane_motion m = lane_motion_of(a, b);
    return {m, 0, {}, {}, squared_length(m)};
}
template <bool Fused, int N, class T>
[[nodiscard, gnu::always_inline]] inline lane_movers lane_movers_of(const flight<N, T>& a,
                                                                    const flight<N, T>& b) noexcept {
    const double since_a = static_cast<double>(as_stored(a.since));
    const double since_b = static_cast<double>(as_stored(b.since));
    const auto lead = two_difference(since_b, since_a);
    const bool a_first = lead.value > 0;
    const vec<N, T>& u = a_first ? a.state.velocity : b.state.velocity;
    lane_movers r;
    r.motion = lane_motion_of(a.state, b.state);
    const double radius = r.motion.xR2.value[0];
    double way2 = 0; // includes R² twice
    r.motion.x01 = moved<Fused>(r.motion.x01, first_two(u), lead, way2);
    const double third = N == 3 ? static_cast<double>(as_stored(u[N - 1])) : 0.0;
    r.motion.xR2 = moved<Fused>(r.motion.xR2, lanes{0, third}, lead, way2);
    r.length2 = 2 * way2 - radius * radius;
    r.start = a_first ? since_b : since_a;
    const exact_pair<double> none{0, 0};
    r.before_a = a_first ? lead : none;
    r.before_b = a_first ? none : exact_pair<double>{-lead.value, -lead.error};
    return r;
}

// A time since the start, on the clock. If the start was scaled before, it lost less than 2^-1000.
[[nodiscard, gnu::always_inline]] inline bounded<double> on_clock(double start, const bounded<double>& time) noexcept {
    const auto sum = two_sum(start, time.high);
    return {sum.value, sum.error + time.low, (1 + 0x1p-40) * time.error + (0x1p-104 * absolute(sum.value) + 0x1p-1000)};
}
template <moving B>
[[nodiscard, gnu::always_inline]] inline bounded<double> on_clock_of(const B& a, const B& b,
                                                                     const bounded<double>& time) noexcept {
    if constexpr (is_flight<B>) {
        const auto since_a = static_cast<double>(as_stored(a.since));
        const auto since_b = static_cast<double>(as_stored(b.since));
        return on_clock(since_a < since_b ? since_b : since_a, time);
    } else {
        return time;
    }
}

// When two movers meet, at about `near` from their start. If not good, nothing is known.
struct time_in_doubles {
    bounded<double> time;
    bool good;
};
// Writes its answer where it is kept: a copy would wait for its parts.
template <moving B, class Kept>
struct time_by_doubles {
    const B *a, *b;
    double near;
    Kept* kept;

    template <bool Fused>
    [[gnu::always_inline]] void operator()(std::bool_constant<Fused>) const noexcept {
        const lane_movers m = lane_movers_of<Fused>(*a, *b);
        const auto r = approach_near<Fused, dimension_of<B>>(m.motion, near, m.length2);
        kept->time = on_clock_of(*a, *b, r.time());
        kept->good = r.good;
    }
};

// The same for two balls whose lengths and velocities are multiplied by powers of two. `near` and the time are in those
// units.
template <int N>
struct time_of_scaled {
    const ball<N, double>*a, *b;
    double by_length, by_velocity, near;

    template <bool Fused>
    [[nodiscard, gnu::always_inline]] time_in_doubles operator()(std::bool_constant<Fused>) const noexcept {
        lane_motion m = lane_motion_of(*a, *b);
        scale(m.x01, by_length);
        scale(m.xR2, by_length);
        scale(m.u01, by_velocity);
        scale(m.u_2, by_velocity);
        const auto r = approach_near<Fused, N>(m, near);
        return {r.time(), r.good};
    }

  private:
    [[gnu::always_inline]] static void scale(exact_pair<lanes>& x, double by) noexcept {
        x.value = settled(x.value * both(by));
        x.error = settled(x.error * both(by));
    }
};

} // namespace graze::inline v0_1::detail
