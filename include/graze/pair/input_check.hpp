// Bad input, named: which argument, which field, what is wrong. Called off the fast path.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/machine/failure.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <string>

namespace graze::inline v0_1::detail {

// Never constexpr: in a constant expression a bad input does not compile, and the compiler shows this call's arguments.
[[noreturn]] inline void reject(const char* argument, const char* what) {
    fail<std::domain_error>(std::string(argument) + ": " + what);
}

// Whether neither radius has its sign set, by their bits; -0 says no and is then looked at more closely.
[[nodiscard]] constexpr bool plain_radii(const double& r, const double& s) noexcept {
    return static_cast<std::int64_t>(bits_of(r) | bits_of(s)) >= 0;
}
[[nodiscard]] constexpr bool plain_radii(const float& r, const float& s) noexcept {
    return static_cast<std::int32_t>(bits_of(r) | bits_of(s)) >= 0;
}
template <std::signed_integral T>
[[nodiscard]] constexpr bool plain_radii(const T& r, const T& s) noexcept {
    return (r | s) >= 0;
}

template <int N, class T>
[[nodiscard]] constexpr bool is_finite(const vec<N, T>& x) noexcept {
    for (int i = 0; i < N; ++i) {
        if (!is_finite_input(x[i])) {
            return false;
        }
    }
    return true;
}

template <int N, class T>
constexpr void require_finite(const vec<N, T>& x, const char* argument, const char* what) {
    if (!is_finite(x)) {
        reject(argument, what);
    }
}

template <int N, class T>
constexpr void check(const ball<N, T>& b, const char* argument) {
    require_finite(b.position, argument, "position is not finite");
    require_finite(b.velocity, argument, "velocity is not finite");
    if (!is_finite_input(b.radius)) {
        reject(argument, "radius is not finite");
    }
    if (to_binary(b.radius).significand < 0) {
        reject(argument, "radius is negative");
    }
}

template <int N, class T>
[[nodiscard]] constexpr bool is_zero(const vec<N, T>& x) noexcept {
    for (int i = 0; i < N; ++i) {
        if (!is_zero(x[i])) {
            return false;
        }
    }
    return true;
}

// Whether two vectors are the same but for signs of zeros, by their bits.
template <int N, class T>
[[nodiscard]] constexpr bool is_same(const vec<N, T>& x, const vec<N, T>& y) noexcept {
    for (int i = 0; i < N; ++i) {
        if (order_of_magnitude(x[i]) != order_of_magnitude(y[i]) ||
            (split(x[i]).significand < 0) != (split(y[i]).significand < 0)) {
            return false;
        }
    }
    return true;
}

template <int N, class T>
constexpr void check(const plane<N, T>& p, const char* argument) {
    require_finite(p.point, argument, "point is not finite");
    require_finite(p.normal, argument, "normal is not finite");
    if (is_zero(p.normal)) {
        reject(argument, "normal is zero");
    }
}

// All but whether edges are parallel, which is a formula's sign.
template <class Edged>
constexpr void check_edges(const Edged& x, const char* argument) {
    require_finite(x.corner, argument, "corner is not finite");
    for (const auto& e : x.edge) {
        require_finite(e, argument, "edge is not finite");
        if (is_zero(e)) {
            reject(argument, "edge is zero");
        }
    }
}
template <int N, class T>
constexpr void check(const wall<N, T>& w, const char* argument) {
    check_edges(w, argument);
}
template <class T>
constexpr void check(const triangle<T>& t, const char* argument) {
    check_edges(t, argument);
}

template <int N, class T>
[[nodiscard]] constexpr const char* name_of(const plane<N, T>&) noexcept {
    return "plane";
}
template <class T>
[[nodiscard]] constexpr const char* name_of(const triangle<T>&) noexcept {
    return "triangle";
}
template <int N, class T>
[[nodiscard]] constexpr const char* name_of(const wall<N, T>&) noexcept {
    return "wall";
}

} // namespace graze::inline v0_1::detail
