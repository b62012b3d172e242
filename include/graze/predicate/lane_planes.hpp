// The encounters of balls with a plane: as many balls at a time as a register has lanes.
#pragma once

#include <graze/formula/plane_crossing.hpp>
#include <graze/pair/lane_shapes.hpp>
#include <graze/predicate/lane_encounter.hpp>

namespace graze::inline v0_1::detail {

template <int N, class T>
struct lane_plane_bounds {
    [[nodiscard]] static consteval auto value() {
        using bound = lane_bound<T>;
        return plane_motion{bounded_vector<N>(bound::rounded_input({1, 0, 0})),
                            bounded_vector<N>(bound::exact_input({0, 1, 0})),
                            bounded_vector<N>(bound::exact_input({0, 0, 1})), bound::exact_input({1, 0, 0})};
    }
};

// |w·n| > K_h length normal is (w·n)² > K_h² length² normal², which takes no root; and so is that of u·n.
template <int N, class T>
struct lane_plane_filter {
    static constexpr double height = filter_constant(plane_height{}, lane_plane_bounds<N, T>::value());
    static constexpr double speed = filter_constant(plane_speed{}, lane_plane_bounds<N, T>::value());
    static constexpr double clearance = filter_constant(plane_clearance{}, lane_plane_bounds<N, T>::value());

    static_assert(has_degrees(plane_height{}, lane_plane_bounds<N, T>::value(), 1, 0, 1));
    static_assert(has_degrees(plane_speed{}, lane_plane_bounds<N, T>::value(), 0, 1, 1));
    static_assert(has_degrees(plane_clearance{}, lane_plane_bounds<N, T>::value(), 2, 0, 2));
    static_assert(height >= speed);
    static_assert(speed * speed * static_cast<double>(lane_range<T>::smallest) *
                          static_cast<double>(lane_range<T>::smallest) >
                      static_cast<double>(std::numeric_limits<T>::min()),
                  "no bound may underflow");
};

// The formulas of a plane in lanes, with the squared scales of the bounds: |w|² + r², |u|², |n|².
template <int N, class V>
struct lane_plane {
    plane_motion<N, V, V, V, V> m;
    V length2, velocity2, normal2;

    [[gnu::always_inline]] lane_plane(const ball<N, V>& b, const plane<N, V>& p) noexcept
        : m(relative_motion_of(b, p)), length2(graze::squared_norm(m.w) + m.r * m.r),
          velocity2(graze::squared_norm(m.u)), normal2(graze::squared_norm(m.n)) {}

    // The lanes in which the clearance is certain and nothing over- or underflows.
    [[nodiscard, gnu::always_inline]] typename V::mask is_clear(const V& clearance) const noexcept {
        using T = typename V::scalar;
        return absolute(clearance) > V(rounded_up<T>(lane_plane_filter<N, T>::clearance)) * (length2 * normal2);
    }
    [[nodiscard, gnu::always_inline]] typename V::mask in_range() const noexcept {
        using range = lane_range<typename V::scalar>;
        return (length2 > V(range::smallest)) & (normal2 > V(range::smallest)) &
               (length2 * normal2 < V(range::largest)) & (velocity2 < V(range::largest));
    }
};

template <int N, class V>
[[nodiscard, gnu::always_inline]] inline lane_encounters<V> classify_lanes(const ball<N, V>& b,
                                                                           const plane<N, V>& p) noexcept {
    using T = typename V::scalar;
    using range = lane_range<T>;
    const lane_plane<N, V> lane(b, p);
    const V height = plane_height{}(lane.m);
    const V speed = plane_speed{}(lane.m);
    const V clearance = plane_clearance{}(lane.m);
    const V zero(0);
    const V bound = V(rounded_up<T>(lane_plane_filter<N, T>::height * lane_plane_filter<N, T>::height)) * lane.normal2;
    const auto parting = ~((height > zero) ^ (speed > zero));
    const auto certain = (height * height > bound * lane.length2) & (speed * speed > bound * lane.velocity2) &
                         (parting | lane.is_clear(clearance)) & lane.in_range() &
                         (lane.velocity2 > V(range::smallest)) & (lane.velocity2 * lane.normal2 < V(range::largest));
    const auto inside = clearance < zero;
    const auto missing = parting & ~parting; // none: a ball that comes closer to a plane meets it
    return {encounter_codes(parting, inside, missing), (all_lanes<V> ^ bits_of(certain)) | sign_bits(b.radius)};
}

template <int N, class V>
[[nodiscard, gnu::always_inline]] inline lane_overlaps<V> overlaps_lanes(const ball<N, V>& b,
                                                                         const plane<N, V>& p) noexcept {
    const lane_plane<N, V> lane(b, p);
    const V clearance = plane_clearance{}(lane.m);
    const auto certain = lane.is_clear(clearance) & lane.in_range();
    return {bits_of(clearance < V(0)), (all_lanes<V> ^ bits_of(certain)) | sign_bits(b.radius)};
}

} // namespace graze::inline v0_1::detail
