// The encounters of balls with a wall or a triangle: as many balls at a time as a register has lanes. Lanes decide far
// balls and those that cross the face; they leave open a ball that comes near a border.
#pragma once

#include <graze/machine/pack_transforms.hpp>
#include <graze/pair/flat_signs.hpp>
#include <graze/pair/lane_shapes.hpp>
#include <graze/predicate/decide_flat.hpp>
#include <graze/predicate/lane_encounter.hpp>

namespace graze::inline v0_1::detail {

// The same numbers in doubles, whose bounds are those of filtered_judge.
template <template <int, class> class X, int N, class V>
[[nodiscard]] X<N, double> numbers_in_doubles(const X<N, V>&);
template <template <class> class X, class V>
[[nodiscard]] X<double> numbers_in_doubles(const X<V>&);

// The lanes in which a sign is certainly positive, and certainly negative.
template <class V>
struct lane_sign {
    typename V::mask positive, negative;
};

// filtered_judge in lanes of doubles that come from inputs of type T.
template <int N, class T, class V>
struct lane_judge {
    V length, velocity, edge; // scales

    [[gnu::always_inline]] explicit lane_judge(const flat_motion<N, V>& m) noexcept
        : length(size_of(m.w) + m.r), velocity(size_of(m.u)), edge(0) {
        V sum(0);
        for (const auto& e : m.e) {
            const V size = size_of(e);
            sum = sum + size;
            edge = graze::larger(edge, size);
        }
        length = length + sum;
        edge = N == 3 && m.is_triangle ? sum : edge;
    }
    [[nodiscard, gnu::always_inline]] typename V::mask in_range() const noexcept {
        constexpr int low = std::is_same_v<T, float> ? -30 : -50; // as usable() has it
        return within_powers<low, 50>(length) & within_powers<low, 50>(velocity) & within_powers<low, 50>(edge);
    }
    template <class F, class X>
    [[nodiscard, gnu::always_inline]] lane_sign<V> operator()(F f, const X& x) const noexcept {
        using in_doubles = decltype(numbers_in_doubles(x));
        using bounds = typename filtered_judge<N, T>::template bounds<in_doubles>;
        constexpr double k = filter_constant(F{}, bounds::value());
        constexpr error_bound::degrees d = filter_degrees(F{}, bounds::value());
        const V bound = k * (power_of<d[0]>(length) * power_of<d[1]>(velocity) * power_of<d[2]>(edge));
        const V value = f(x);
        return {value > bound, value < -bound};
    }

  private:
    [[nodiscard, gnu::always_inline]] static V size_of(const vec<N, V>& x) noexcept {
        V sum = absolute(x[0]);
        for (int i = 1; i < N; ++i) {
            sum = sum + absolute(x[i]);
        }
        return sum;
    }
};

// Whether the centre's line, which crosses the plane outside of border k, passes that border at more than r. It then
// passes everything inside of the border at no less.
template <int N, class V, class Judge>
[[nodiscard, gnu::always_inline]] inline typename V::mask
passes_border(const flat_motion<N, V>& m, const flat_way<N, V>& way, int k, const Judge& judge) noexcept {
    if constexpr (N == 2) {
        const vec<N, V> w = k == 0 ? m.w : m.w - m.e[0];
        return judge(corner_discriminant{}, corner_of(w, m.u, m.e[0], m.r, way.speed)).negative;
    } else {
        const vec<N, V> d = k >= 2 ? m.e[0] : k == 1 && m.is_triangle ? m.e[1] - m.e[0] : m.e[1];
        const V inside = inside_border{k, m.is_triangle}(way);
        return judge(border_discriminant{}, edge_of(m.w, m.u, d, m.r, inside, way.speed, way.speed)).negative;
    }
}

// recede: no point of the shape comes closer, or the line crosses the face and the centre is beyond it. miss: all of
// it comes closer, and the line passes a border. hit: the line crosses the face, and the ball is not yet in the slab.
template <int N, class T, class V>
[[nodiscard, gnu::always_inline]] inline lane_encounters<V> classify_flat_lanes(const flat_motion<N, V>& m,
                                                                                unsigned odd_radii) noexcept {
    using mask = typename V::mask;
    const lane_judge<N, T, V> judge(m);
    const auto extent = extent_of(m);
    const mask nothing_comes = judge(recedes_from_all{}, extent).positive;
    const mask all_comes = judge(recedes_from_any{}, extent).negative;
    const auto way = way_of(m);
    const auto speed = judge(way_speed{}, way);
    mask crosses = speed.positive | speed.negative;
    mask passes = crosses & ~crosses;
    for (int k = 0; k < borders_of(N, m.is_triangle); ++k) {
        const auto side = judge(inside_border{k, m.is_triangle}, way);
        const mask outside = (side.positive & speed.negative) | (side.negative & speed.positive);
        crosses = crosses & ((side.positive & speed.positive) | (side.negative & speed.negative));
        passes = passes | (outside & passes_border(m, way, k, judge));
    }
    const auto height = judge(way_height{}, way);
    const mask beyond = crosses & ((height.positive & speed.positive) | (height.negative & speed.negative));
    const mask ahead = crosses & ((height.positive & speed.negative) | (height.negative & speed.positive));
    const mask parting = nothing_comes | beyond;
    const mask missing = all_comes & passes;
    const mask hit = ahead & judge(way_clearance{}, way).positive;
    const mask certain = (parting | missing | hit) & judge(edges_span{}, edges_of(m)).positive & judge.in_range();
    return {encounter_codes(parting, mask{}, missing), (all_lanes<V> ^ bits_of(certain)) | odd_radii};
}

template <int N, class V, class Shape>
[[nodiscard, gnu::always_inline]] inline flat_motion<N, V> lane_motion_of(const ball<N, V>& b,
                                                                          const Shape& shape) noexcept {
    return {b.position - shape.corner, b.velocity, shape.edge, b.radius, is_triangle<Shape>};
}

template <class Shape>
concept flat_shape = requires(const Shape& s) {
    s.edge;
};

template <int N, int Lanes, flat_shape Shape>
[[nodiscard, gnu::always_inline]] inline lane_encounters<pack<double, Lanes>>
classify_lanes(const ball<N, pack<double, Lanes>>& b, const Shape& shape) noexcept {
    return classify_flat_lanes<N, double>(lane_motion_of(b, shape), sign_bits(b.radius));
}
// Floats are computed as doubles, one half of the lanes after the other.
template <int N, int Lanes, flat_shape Shape>
[[nodiscard, gnu::always_inline]] inline lane_encounters<pack<float, Lanes>>
classify_lanes(const ball<N, pack<float, Lanes>>& b, const Shape& shape) noexcept {
    const auto first = classify_flat_lanes<N, float>(lane_motion_of(widened<0>(b), shape), 0);
    const auto second = classify_flat_lanes<N, float>(lane_motion_of(widened<1>(b), shape), 0);
    constexpr int half = Lanes / 2;
    return {pack<float, Lanes>::made(
                [&](int k) { return static_cast<float>(k < half ? first.codes[k] : second.codes[k - half]); }),
            first.open | second.open << half | sign_bits(b.radius)};
}

} // namespace graze::inline v0_1::detail
