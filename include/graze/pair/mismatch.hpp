// Two shapes of different number types or dimensions, which are no pair.
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
vec<N, T> vector_in(const ball<N, T>&);
template <int N, class T>
vec<N, T> vector_in(const flight<N, T>&);
template <int N, class T>
vec<N, T> vector_in(const plane<N, T>&);
template <int N, class T>
vec<N, T> vector_in(const wall<N, T>&);
template <class T>
vec<3, T> vector_in(const triangle<T>&);

template <class A, class B>
concept mismatched = requires(const A& a, const B& b) {
    vector_in(a);
    vector_in(b);
}
&&!std::is_same_v<decltype(vector_in(std::declval<const A&>())), decltype(vector_in(std::declval<const B&>()))>;

} // namespace detail

} // namespace graze::inline v0_1
