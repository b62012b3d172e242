// Balls, flights, planes, walls and triangles of users' own types, read in place.
#pragma once

#include <graze/linear/vector_access.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <array>

namespace graze::inline v0_1 {

namespace detail {

template <class S>
inline constexpr bool is_own_shape = false;
template <int N, class T>
inline constexpr bool is_own_shape<ball<N, T>> = true;
template <int N, class T>
inline constexpr bool is_own_shape<flight<N, T>> = true;
template <int N, class T>
inline constexpr bool is_own_shape<plane<N, T>> = true;
template <int N, class T>
inline constexpr bool is_own_shape<wall<N, T>> = true;
template <class T>
inline constexpr bool is_own_shape<triangle<T>> = true;

template <class B>
struct found_ball {};

template <class B>
requires(!is_own_shape<B> && requires(const B& b) {
    b.position;
    b.velocity;
    b.radius;
}) struct found_ball<B> {
    [[nodiscard]] static constexpr const auto& position(const B& b) { return b.position; }
    [[nodiscard]] static constexpr const auto& velocity(const B& b) { return b.velocity; }
    [[nodiscard]] static constexpr const auto& radius(const B& b) { return b.radius; }
    template <class C>
    requires requires(const C& c) { c.mass; }
    [[nodiscard]] static constexpr const auto& mass(const C& b) { return b.mass; }
    template <class C>
    requires requires(const C& c) { c.since; }
    [[nodiscard]] static constexpr const auto& since(const C& b) { return b.since; }
};

template <class P>
struct found_plane {};

template <class P>
requires(!is_own_shape<P> && requires(const P& p) {
    p.point;
    p.normal;
}) struct found_plane<P> {
    [[nodiscard]] static constexpr const auto& point(const P& p) { return p.point; }
    [[nodiscard]] static constexpr const auto& normal(const P& p) { return p.normal; }
};

} // namespace detail

// How B is read as a ball, P as a plane, W as a wall, T as a triangle. Specialise them for types whose members have
// other names: static functions of a const reference, each returning a number or a vector that vector_access reads. All
// vectors and numbers of a shape are of one number type.
//   ball_access<B>      position, velocity, radius; optionally mass (otherwise 1) and since, which makes a flight of it
//   plane_access<P>     point, normal
//   wall_access<W>      corner, edge(w, i): i is 0, in space also 1
//   triangle_access<T>  corner, edge(t, i): i is 0 or 1
// A class with members of these names needs no specialisation for balls and planes.
template <class B>
struct ball_access : detail::found_ball<B> {};
template <class P>
struct plane_access : detail::found_plane<P> {};
template <class W>
struct wall_access {};
template <class T>
struct triangle_access {};

// A type that can be read as a ball or a flight, a plane, a wall, a triangle.
template <class B>
concept ball_like = requires(const B& b) {
    ball_access<B>::position(b);
    ball_access<B>::velocity(b);
    ball_access<B>::radius(b);
};
template <class P>
concept plane_like = requires(const P& p) {
    plane_access<P>::point(p);
    plane_access<P>::normal(p);
};
template <class W>
concept wall_like = requires(const W& w) {
    wall_access<W>::corner(w);
    wall_access<W>::edge(w, 0);
};
template <class T>
concept triangle_like = requires(const T& t) {
    triangle_access<T>::corner(t);
    triangle_access<T>::edge(t, 0);
};
template <class S>
concept own_shape = detail::is_own_shape<S>;
template <class S>
concept foreign_shape = !own_shape<S> && (ball_like<S> || plane_like<S> || wall_like<S> || triangle_like<S>);

namespace detail {

// Dimension and number type of a type that vector_access reads.
template <class V>
struct read_vector : vector_access<V> {
    static_assert(vector_like<V>,
                  "graze: this is not read as a vector of two or three components: graze/linear/adapter/ "
                  "has Eigen's, glm's and Bullet's; specialise graze::vector_access for another one");
};
template <class V>
using vec_like = read_vector<std::remove_cvref_t<V>>;

// A number or vector of a shape. It must have the shape's number type already: nothing is rounded on the way.
template <class T, class U>
[[nodiscard]] constexpr const T& number_as(const U& x) noexcept {
    static_assert(std::same_as<T, U>, "graze: the numbers and vectors of a shape are of one number type");
    return x;
}
template <class As, class V>
[[nodiscard]] constexpr auto vec_as(const V& v) {
    static_assert(std::same_as<typename As::scalar, typename vec_like<V>::scalar> &&
                      As::dimension == vec_like<V>::dimension,
                  "graze: the vectors of a shape are of one number type and one dimension");
    return vec_of(v);
}

} // namespace detail

// The shape itself, or graze's shape in its place: a ball, flight, plane, wall or triangle.
template <own_shape S>
[[nodiscard]] constexpr const S& shape_of(const S& s) noexcept {
    return s;
}
template <ball_like B>
[[nodiscard]] constexpr auto shape_of(const B& b) {
    using access = ball_access<B>;
    using V = detail::vec_like<decltype(access::position(b))>;
    using T = typename V::scalar;
    const auto made = [&] {
        ball<V::dimension, T> r{vec_of(access::position(b)), detail::vec_as<V>(access::velocity(b)),
                                detail::number_as<T>(access::radius(b))};
        if constexpr (requires { access::mass(b); }) {
            r.mass = detail::number_as<T>(access::mass(b));
        }
        return r;
    };
    if constexpr (requires { access::since(b); }) {
        return flight<V::dimension, T>{made(), detail::number_as<T>(access::since(b))};
    } else {
        return made();
    }
}
template <plane_like P>
[[nodiscard]] constexpr auto shape_of(const P& p) {
    using access = plane_access<P>;
    using V = detail::vec_like<decltype(access::point(p))>;
    return plane<V::dimension, typename V::scalar>{vec_of(access::point(p)), detail::vec_as<V>(access::normal(p))};
}
template <wall_like W>
[[nodiscard]] constexpr auto shape_of(const W& w) {
    using access = wall_access<W>;
    using V = detail::vec_like<decltype(access::corner(w))>;
    using T = typename V::scalar;
    if constexpr (V::dimension == 2) {
        return wall<2, T>{vec_of(access::corner(w)), {{detail::vec_as<V>(access::edge(w, 0))}}};
    } else {
        return wall<3, T>{vec_of(access::corner(w)),
                          {{detail::vec_as<V>(access::edge(w, 0)), detail::vec_as<V>(access::edge(w, 1))}}};
    }
}
template <triangle_like S>
[[nodiscard]] constexpr auto shape_of(const S& t) {
    using access = triangle_access<S>;
    using V = detail::vec_like<decltype(access::corner(t))>;
    return triangle<typename V::scalar>{
        vec_of(access::corner(t)), {{detail::vec_as<V>(access::edge(t, 0)), detail::vec_as<V>(access::edge(t, 1))}}};
}

} // namespace graze::inline v0_1
