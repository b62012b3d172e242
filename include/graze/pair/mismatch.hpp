// Two shapes that are no pair: of different number types or dimensions.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <type_traits>

namespace graze::inline v0_1 {

namespace detail {

// Names a shape's vectors, and so its dimension and number type.
template <int N, class T>
vec<N, T> vector_of(const ball<N, T>&);
template <int N, class T>
vec<N, T> vector_of(const flight<N, T>&);
template <int N, class T>
vec<N, T> vector_of(const plane<N, T>&);
template <int N, class T>
vec<N, T> vector_of(const wall<N, T>&);
template <class T>
vec<3, T> vector_of(const triangle<T>&);

template <class A, class B>
concept mismatched = requires(const A& a, const B& b) {
    vector_of(a);
    vector_of(b);
}
&&!std::is_same_v<decltype(vector_of(std::declval<const A&>())), decltype(vector_of(std::declval<const B&>()))>;

} // namespace detail

} // namespace graze::inline v0_1
