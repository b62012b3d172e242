// The encounters of balls with balls: as many pairs at a time as a register has lanes.
#pragma once

#include <graze/predicate/filtered_balls.hpp>
#include <graze/predicate/lane_encounter.hpp>

namespace graze::inline v0_1::detail {

template <int N, class T>
struct lane_ball_bounds {
    [[nodiscard]] static consteval auto value() {
        using bound = lane_bound<T>;
        const bound length = bound::rounded_input({1, 0, 0});
        return relative_motion{bounded_vector<N>(length), bounded_vector<N>(bound::rounded_input({0, 1, 0})), length};
    }
};

// The constants of ball_filter, in arithmetic of T.
template <int N, class T>
struct lane_ball_filter {
    static constexpr double h = filter_constant(coefficient_h{}, lane_ball_bounds<N, T>::value());
    static constexpr double c = filter_constant(coefficient_c{}, lane_ball_bounds<N, T>::value());
    static constexpr double discriminant = filter_constant(halved_of_motion{}, lane_ball_bounds<N, T>::value());

    static_assert(has_degrees(coefficient_h{}, lane_ball_bounds<N, T>::value(), 1, 1, 0));
    static_assert(has_degrees(coefficient_c{}, lane_ball_bounds<N, T>::value(), 2, 0, 0));
    static_assert(has_degrees(halved_of_motion{}, lane_ball_bounds<N, T>::value(), 2, 2, 0));
    static_assert(discriminant > 2 * h * h && discriminant > 2 * c, "one constant must serve all three signs");
};

// The formulas of balls in lanes, with the scales of the bounds.
template <class V>
struct lane_quadratic {
    quadratic<V, V, V> q;
    V length2; // |Δx|² + R²
    unsigned odd_radii;

    template <int N>
    [[gnu::always_inline]] lane_quadratic(const ball<N, V>& a, const ball<N, V>& b) noexcept
        : lane_quadratic(relative_motion_of(a, b), sign_bits(a.radius) | sign_bits(b.radius)) {}

  private:
    template <int N>
    [[gnu::always_inline]] lane_quadratic(const relative_motion<N, V, V, V>& m, unsigned odd) noexcept
        : q(quadratic_of(m)), length2(graze::squared_norm(m.dx) + m.R * m.R), odd_radii(odd) {}
};

// The three signs by one constant, as in started_filter; see ball_filter. A NaN or an infinity makes a comparison
// false, and leaves its lane open.
template <int N, class V>
struct filtered_lanes {
    quadratic<V, V, V> q;
    V discriminant;
    typename V::mask parting, inside, missing;
    unsigned open;

    [[gnu::always_inline]] filtered_lanes(const ball<N, V>& a, const ball<N, V>& b) noexcept
        : filtered_lanes(lane_quadratic<V>(a, b)) {}

  private:
    [[gnu::always_inline]] explicit filtered_lanes(const lane_quadratic<V>& lane) noexcept
        : q(lane.q), discriminant(discriminant_halved{}(q)), parting(q.h > V(0)), inside(q.c < V(0)),
          missing(discriminant < V(0)) {
        using T = typename V::scalar;
        using range = lane_range<T>;
        const V scale = q.a * lane.length2;
        const V bound = V(rounded_up<T>(lane_ball_filter<N, T>::discriminant)) * scale;
        const auto others = (absolute(discriminant) > bound) & (absolute(q.a * q.c) > bound);
        const auto certain = (q.h * q.h > bound) & (parting | others) & (q.a > V(range::smallest)) &
                             (lane.length2 > V(range::smallest)) & (scale < V(range::largest));
        open = (all_lanes<V> ^ bits_of(certain)) | lane.odd_radii;
    }
};

template <int N, class V>
[[nodiscard, gnu::always_inline]] inline lane_encounters<V> classify_lanes(const ball<N, V>& a,
                                                                           const ball<N, V>& b) noexcept {
    const filtered_lanes<N, V> lane(a, b);
    return {encounter_codes(lane.parting, lane.inside, lane.missing), lane.open};
}

// The answer does not depend on velocities, but bad ones are still rejected.
template <int N, class V>
[[nodiscard, gnu::always_inline]] inline lane_overlaps<V> overlaps_lanes(const ball<N, V>& a,
                                                                         const ball<N, V>& b) noexcept {
    using T = typename V::scalar;
    using range = lane_range<T>;
    const lane_quadratic<V> lane(a, b);
    const V bound = V(rounded_up<T>(lane_ball_filter<N, T>::c)) * lane.length2;
    const auto certain = (absolute(lane.q.c) > bound) & (lane.length2 > V(range::smallest)) &
                         (lane.length2 < V(range::largest)) & (lane.q.a < V(range::largest));
    return {bits_of(lane.q.c < V(0)), (all_lanes<V> ^ bits_of(certain)) | lane.odd_radii};
}

} // namespace graze::inline v0_1::detail
