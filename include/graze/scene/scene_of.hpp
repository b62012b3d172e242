// Scenes of users' own shapes.
#pragma once

#include <graze/pair/moving.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/shape_access.hpp>

#include <array>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze::inline v0_1 {

// A scene that owns its shapes. Every function that takes a scene takes it. It can be moved, and not copied.
template <int N, class T = double>
class owned_scene : public scene<N, T> {
  public:
    owned_scene(std::vector<ball<N, T>> some_balls, std::vector<plane<N, T>> some_planes,
                std::vector<wall<N, T>> some_walls, std::vector<triangle<T>> some_triangles = {})
        : balls_(std::move(some_balls)), planes_(std::move(some_planes)), walls_(std::move(some_walls)),
          triangles_(std::move(some_triangles)) {
        scene<N, T>::balls = balls_;
        scene<N, T>::planes = planes_;
        scene<N, T>::walls = walls_;
        if constexpr (N == 3) {
            scene<N, T>::triangles = triangles_;
        }
    }
    owned_scene(owned_scene&&) noexcept = default; // what a vector holds stays where it is
    owned_scene& operator=(owned_scene&&) noexcept = default;

  private:
    std::vector<ball<N, T>> balls_;
    std::vector<plane<N, T>> planes_;
    std::vector<wall<N, T>> walls_;
    std::vector<triangle<T>> triangles_;
};

namespace detail {

template <class R>
using shape_in = std::remove_cvref_t<decltype(shape_of(*std::ranges::begin(std::declval<const R&>())))>;

template <class Shape, class R>
[[nodiscard]] std::vector<Shape> shapes_of(const R& all) {
    std::vector<Shape> result;
    for (const auto& one : all) {
        result.push_back(shape_of(one));
    }
    return result;
}

} // namespace detail

// The scene of balls, planes, walls and triangles of any types that shape_of reads, graze's own among them, each copied
// once. All are of one dimension and number type, that of the balls.
template <std::ranges::input_range Balls, int N = detail::dimension_of<detail::shape_in<Balls>>,
          class T = detail::number_in<detail::shape_in<Balls>>, class Planes = std::array<plane<N, T>, 0>,
          class Walls = std::array<wall<N, T>, 0>, class Triangles = std::array<triangle<T>, 0>>
[[nodiscard]] owned_scene<N, T> scene_of(const Balls& balls, const Planes& planes = {}, const Walls& walls = {},
                                         const Triangles& triangles = {}) {
    return {detail::shapes_of<ball<N, T>>(balls), detail::shapes_of<plane<N, T>>(planes),
            detail::shapes_of<wall<N, T>>(walls), detail::shapes_of<triangle<T>>(triangles)};
}

} // namespace graze::inline v0_1
