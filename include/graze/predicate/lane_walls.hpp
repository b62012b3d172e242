// The encounters of balls with a wall or a triangle: as many balls at a time as a register has lanes. The lanes leave
// open balls that are at rest, fly along the plane or are near where an answer changes.
#pragma once

#include <graze/pair/lane_shapes.hpp>
#include <graze/pair/pair.hpp>
#include <graze/predicate/lane_encounter.hpp>
#include <graze/predicate/lane_flat.hpp>

namespace graze::inline v0_1::detail {

template <class Shape>
concept flat_shape = requires(const Shape& s) {
    s.edge;
};

// In lanes of doubles that come from inputs of type T.
template <class T, int N, class V, class Shape>
struct lane_pair_of_flat {
    flat_motion<N, V> motion;
    lane_judge<N, T, V> judge;
    lane_flat<N, T, V, is_triangle<Shape>> flat;
    unsigned odd_radii;

    [[gnu::always_inline]] lane_pair_of_flat(const ball<N, V>& b, const Shape& shape) noexcept
        : motion{make_vec<N>([&](int i) { return settled(b.position[i] - shape.corner[i]); }), b.velocity, shape.edge,
                 b.radius, is_triangle<Shape>},
          judge(motion), flat(motion, judge), odd_radii(sign_bits(b.radius)) {}

    // The lanes that have no answer, if `certain` ones have one for good input.
    [[nodiscard, gnu::always_inline]] unsigned open(const typename V::mask& certain) const noexcept {
        return (all_lanes<V> ^ bits_of(certain & judge(edges_span{}, edges_of(motion)).positive)) | odd_radii;
    }
};

template <class T, int N, class V, class Shape>
[[nodiscard, gnu::noinline, gnu::flatten]] lane_encounters<V> classify_flat_lanes(const ball<N, V>& b,
                                                                                  const Shape& shape) noexcept {
    const lane_pair_of_flat<T, N, V, Shape> pair(b, shape);
    const auto found = pair.flat.what();
    return {encounter_codes(found.parting, found.inside, found.missing),
            pair.open((found.parting | found.missing | found.inside | found.hitting) & pair.judge.in_range())};
}
template <class T, int N, class V, class Shape>
[[nodiscard, gnu::noinline, gnu::flatten]] lane_overlaps<V> overlaps_flat_lanes(const ball<N, V>& b,
                                                                                const Shape& shape) noexcept {
    const lane_pair_of_flat<T, N, V, Shape> pair(b, shape);
    const auto clearance = pair.flat.clearance();
    return {bits_of(clearance.negative), pair.open(clearance.certain() & pair.judge.in_range_or_at_rest())};
}

template <int N, int Lanes, flat_shape Shape>
[[nodiscard, gnu::always_inline]] inline lane_encounters<pack<double, Lanes>>
classify_lanes(const ball<N, pack<double, Lanes>>& b, const Shape& shape) noexcept {
    return classify_flat_lanes<double>(b, shape);
}
template <int N, int Lanes, flat_shape Shape>
[[nodiscard, gnu::always_inline]] inline lane_overlaps<pack<double, Lanes>>
overlaps_lanes(const ball<N, pack<double, Lanes>>& b, const Shape& shape) noexcept {
    return overlaps_flat_lanes<double>(b, shape);
}

// Floats are computed as doubles, one half of the lanes after the other.
template <int N, int Lanes, flat_shape Shape>
[[nodiscard, gnu::always_inline]] inline lane_encounters<pack<float, Lanes>>
classify_lanes(const ball<N, pack<float, Lanes>>& b, const Shape& shape) noexcept {
    const auto first = classify_flat_lanes<float>(widened<0>(b), shape);
    const auto second = classify_flat_lanes<float>(widened<1>(b), shape);
    constexpr int half = Lanes / 2;
    return {pack<float, Lanes>::made(
                [&](int k) { return static_cast<float>(k < half ? first.codes[k] : second.codes[k - half]); }),
            first.open | second.open << half};
}
template <int N, int Lanes, flat_shape Shape>
[[nodiscard, gnu::always_inline]] inline lane_overlaps<pack<float, Lanes>>
overlaps_lanes(const ball<N, pack<float, Lanes>>& b, const Shape& shape) noexcept {
    const auto first = overlaps_flat_lanes<float>(widened<0>(b), shape);
    const auto second = overlaps_flat_lanes<float>(widened<1>(b), shape);
    constexpr int half = Lanes / 2;
    return {first.inside | second.inside << half, first.open | second.open << half};
}

} // namespace graze::inline v0_1::detail
