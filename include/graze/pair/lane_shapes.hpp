// Balls and what they meet, in the lanes of packs.
#pragma once

#include <graze/number/pack_number.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <array>
#include <cstddef>

namespace graze::inline v0_1::detail {

// The same in every lane.
template <class V, int N, class T>
[[nodiscard, gnu::always_inline]] inline vec<N, V> filled(const vec<N, T>& x) noexcept {
    return make_vec<N>([&x](int k) { return V(static_cast<typename V::scalar>(x[k])); });
}
template <class V, int N, class T>
[[nodiscard, gnu::always_inline]] inline ball<N, V> filled(const ball<N, T>& b) noexcept {
    return {filled<V>(b.position), filled<V>(b.velocity), V(b.radius)};
}

// The other thing of the pairs in lanes of V, the same in every lane: a plane, and in doubles a wall or a triangle.
template <class V, int N, class T>
[[nodiscard, gnu::always_inline]] inline plane<N, V> in_lanes(const plane<N, T>& p) noexcept {
    return {filled<V>(p.point), filled<V>(p.normal)};
}

template <class V>
using lanes_of_doubles = pack<double, V::lanes* static_cast<int>(sizeof(typename V::scalar)) / 8>;
template <class V, std::size_t Edges, int N, class T>
[[nodiscard, gnu::always_inline]] inline std::array<vec<N, V>, Edges>
filled(const std::array<vec<N, T>, Edges>& edge) noexcept {
    std::array<vec<N, V>, Edges> r;
    for (std::size_t i = 0; i < Edges; ++i) {
        r[i] = filled<V>(edge[i]);
    }
    return r;
}
template <class V, int N, class T>
[[nodiscard, gnu::always_inline]] inline wall<N, lanes_of_doubles<V>> in_lanes(const wall<N, T>& w) noexcept {
    return {filled<lanes_of_doubles<V>>(w.corner), filled<lanes_of_doubles<V>>(w.edge)};
}
template <class V, class T>
[[nodiscard, gnu::always_inline]] inline triangle<lanes_of_doubles<V>> in_lanes(const triangle<T>& t) noexcept {
    return {filled<lanes_of_doubles<V>>(t.corner), filled<lanes_of_doubles<V>>(t.edge)};
}

// Half of the lanes as doubles, the first or the second.
template <int Half, int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<double, Lanes / 2> widened(const pack<float, Lanes>& x) noexcept {
    return pack<double, Lanes / 2>::made([&](int k) { return static_cast<double>(x[Half * Lanes / 2 + k]); });
}
template <int Half, int N, int Lanes>
[[nodiscard, gnu::always_inline]] inline ball<N, pack<double, Lanes / 2>>
widened(const ball<N, pack<float, Lanes>>& b) noexcept {
    const auto vector = [](const auto& x) { return make_vec<N>([&x](int k) { return widened<Half>(x[k]); }); };
    return {vector(b.position), vector(b.velocity), widened<Half>(b.radius)};
}

} // namespace graze::inline v0_1::detail
