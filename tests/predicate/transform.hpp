// Shapes moved, mirrored and scaled.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <type_traits>

namespace transform {

// A shape whose vectors are replaced by length(v), velocity(v) or normal(v), depending on what they are.
template <int N, class T, class L, class V, class E>
graze::ball<N, T> apply(graze::ball<N, T> b, L length, V velocity, E) {
    b.position = length(b.position);
    b.velocity = velocity(b.velocity);
    return b;
}
template <int N, class T, class L, class V, class E>
graze::plane<N, T> apply(graze::plane<N, T> p, L length, V, E normal) {
    p.point = length(p.point);
    p.normal = normal(p.normal);
    return p;
}
template <int N, class T, class L, class V, class E>
graze::wall<N, T> apply(graze::wall<N, T> w, L length, V, E) {
    w.corner = length(w.corner);
    for (auto& e : w.edge) {
        e = length(e);
    }
    return w;
}
template <class T, class L, class V, class E>
graze::triangle<T> apply(graze::triangle<T> t, L length, V, E) {
    t.corner = length(t.corner);
    for (auto& e : t.edge) {
        e = length(e);
    }
    return t;
}
template <class Shape, class F>
Shape apply(const Shape& shape, F f) {
    return apply(shape, f, f, f);
}

// Axis i becomes axis i + shift, modulo N.
template <class Shape>
Shape permuted(const Shape& shape, int shift) {
    return apply(shape, [shift]<int N, class T>(const graze::vec<N, T>& x) {
        return graze::make_vec<N>([&](int i) { return x[(i + shift) % N]; });
    });
}

// Mirrors the axes whose bit is set.
template <class Shape>
Shape reflected(const Shape& shape, unsigned axes) {
    return apply(shape, [axes]<int N, class T>(const graze::vec<N, T>& x) {
        return graze::make_vec<N>([&](int i) { return (axes >> i & 1U) != 0 ? static_cast<T>(-x[i]) : x[i]; });
    });
}

// times(x, kind) for every number of the shape; kind 0, 1 and 2 are lengths, velocities and normals.
template <class Shape, class F>
Shape scaled(const Shape& shape, F times) {
    const auto kind = [&](int k) {
        return [k, times]<int N, class T>(const graze::vec<N, T>& x) {
            return graze::make_vec<N>([&](int i) { return times(x[i], k); });
        };
    };
    Shape result = apply(shape, kind(0), kind(1), kind(2));
    if constexpr (requires { result.radius; }) {
        result.radius = times(result.radius, 0);
    }
    return result;
}

} // namespace transform
