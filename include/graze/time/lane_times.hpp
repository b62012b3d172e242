// When the balls of many pairs touch first, correctly rounded, in as many pairs at a time as a register has lanes.
#pragma once

#include <graze/exact/rounding.hpp>
#include <graze/formula/roots.hpp>
#include <graze/machine/pack_transforms.hpp>
#include <graze/pair/lane_shapes.hpp>
#include <graze/predicate/lane_balls.hpp>
#include <graze/time/newton_approach.hpp>

#include <array>
#include <cstddef>

namespace graze::inline v0_1::detail {

// Times that take no arithmetic: 0 for an overlap, +infinity for pairs that never touch. For a hit, a time near the
// exact one.
template <class V>
struct lane_times {
    V time;
    unsigned open;
    unsigned hits;
};

template <int N, class V>
[[nodiscard, gnu::always_inline]] inline lane_times<V> first_times(const ball<N, V>& a, const ball<N, V>& b) noexcept {
    using T = typename V::scalar;
    using mask = typename V::mask;
    const filtered_lanes<N, V> lane(a, b);
    const mask never = lane.parting | (lane.missing & ~lane.inside);
    const mask hit = ~(lane.parting | lane.inside | lane.missing);
    lane_times<V> r;
    r.open = lane.open;
    r.hits = bits_of(hit) & ~r.open;
    const mask infinity = mask::filled(static_cast<typename mask::integer>(format_of<T>.infinite_bits()));
    mask time = never & infinity;
    if constexpr (std::is_same_v<T, double>) { // floats are done in doubles later
        // Lanes without a hit get numbers that neither divide by zero nor give a NaN.
        const V d = V::of(hit & lane.discriminant.bits()), h = chosen(hit, lane.q.h, V(-1));
        time = time | (hit & root_stable{}(lane.q.c, h, plain_sqrt(d)).bits());
    }
    r.time = V::of(time);
    return r;
}

// Numbers, and the lanes in which they are certain.
template <class V>
struct certain_lanes {
    V value;
    unsigned certain;
};

// x rounded to double, as certainly_rounded does it.
template <class V>
[[nodiscard, gnu::always_inline]] inline certain_lanes<V> rounded_lanes(const bounded<V>& x, rounding mode) noexcept {
    using mask = typename V::mask;
    if (mode == rounding::nearest) {
        const ends<V> interval = ends_of<double>(x);
        return {interval.upper, bits_of(~(interval.lower < interval.upper))};
    }
    const auto [r, rest] = two_sum(x.high, x.low);
    const mask certain = (r > V(0x1p-900)) & (absolute(rest) > x.error);
    const mask above = rest > V(0);
    // A mask is -1 where it holds: one less in the bits of a number.
    const mask bits =
        mode == rounding::downward ? mask{r.bits().value + (~above).value} : mask{r.bits().value - above.value};
    return {V::of(bits), bits_of(certain)};
}

// The motion of two balls in the form that approach_near takes.
template <int N, class V>
[[nodiscard, gnu::always_inline]] inline motion_side_by_side<two_packs<V>> side_by_side(const ball<N, V>& a,
                                                                                        const ball<N, V>& b) noexcept {
    const V zero(0);
    const auto difference = [](const V& x, const V& y) __attribute__((always_inline)) { return two_difference(x, y); };
    const auto two = [](const exact_pair<V>& x, const exact_pair<V>& y) __attribute__((always_inline)) {
        return exact_pair<two_packs<V>>{{x.value, y.value}, {x.error, y.error}};
    };
    const exact_pair<V> none{zero, zero};
    exact_pair<V> x2 = none, u2 = none;
    if constexpr (N == 3) {
        x2 = difference(a.position[2], b.position[2]);
        u2 = difference(a.velocity[2], b.velocity[2]);
    }
    return {two(difference(a.position[0], b.position[0]), difference(a.position[1], b.position[1])),
            two(difference(a.radius, -b.radius), x2),
            two(difference(a.velocity[0], b.velocity[0]), difference(a.velocity[1], b.velocity[1])), two(none, u2)};
}

// When two balls of doubles that meet near `time` do meet, rounded to nearest or in another mode.
template <bool Fused, int N, class V>
[[nodiscard, gnu::always_inline]] inline certain_lanes<V> impact_lanes(const ball<N, V>& a, const ball<N, V>& b,
                                                                       const V& time, rounding mode) noexcept {
    const auto m = side_by_side(a, b);
    const auto t0 = as_factor<Fused>(both(time));
    const auto y01 = displacement(m.x01, m.u01, t0);
    const auto yR2 = displacement(m.xR2, m.u_2, t0);
    const auto step = step_from(m, y01, yR2, squared_length(m));
    const auto found = rounded_lanes(bounded<V>{time, step.t1, step.error}, mode);
    return {found.value, found.certain & bits_of(step.good)};
}

// The bounds of an exact number, and the lanes in which they are certain.
template <class V>
struct enclosed_lanes {
    V lower, upper;
    unsigned certain;
};

// When two balls of floats, given as doubles, meet, as time_of_impact encloses it. They must certainly meet.
template <int N, class V>
[[nodiscard, gnu::always_inline]] inline enclosed_lanes<V> enclose_lanes(const ball<N, V>& a,
                                                                         const ball<N, V>& b) noexcept {
    using constant = ball_filter<N, float>;
    constexpr double clear = started_filter<float, constant>::clear;
    constexpr double error = 1.5 * (constant::c + constant::discriminant + constant::h);
    const lane_quadratic<V> lane(a, b);
    const auto& q = lane.q;
    const V d = discriminant_halved{}(q);
    const V scale = q.a * lane.length2;
    const V bound = V(constant::discriminant) * scale;
    const auto certain = (d > clear * bound) & (q.a * q.c > bound) & (q.a > V(smallest_square<float>)) &
                         (lane.length2 > V(smallest_square<float>));
    const V root = plain_sqrt(chosen(certain, d, V(1)));
    const V time = root_stable{}(q.c, q.h, root);
    const V off = error * lane.length2 / root + 0x1p-45 * time;
    return {time - off, time + off, bits_of(certain)};
}

// x rounded; needs doubles that round to nearest and keep subnormals.
[[nodiscard]] inline float rounded_to_float(double x, rounding mode) noexcept {
    const float nearest = static_cast<float>(x);
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(nearest);
    const double back = static_cast<double>(nearest);
    return mode == rounding::downward && back > x ? std::bit_cast<float>(bits - 1)
           : mode == rounding::upward && back < x ? std::bit_cast<float>(bits + 1)
                                                  : nearest;
}

} // namespace graze::inline v0_1::detail
