// Names bad input: which argument, which field, what is wrong. Not on the fast path.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/machine/failure.hpp>
#include <graze/pair/moving.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <string>

namespace graze::inline v0_1 {

// What is wrong with an input: in which argument ("ball a"), in which field of it ("radius"), and what ("radius is
// negative"). All three are literals.
struct input_error {
    const char* argument = nullptr;
    const char* field = nullptr;
    const char* what = nullptr;

    // As the exception says it: "ball a: radius is negative".
    [[nodiscard]] std::string message() const { return std::string(argument) + ": " + what; }
};

} // namespace graze::inline v0_1

namespace graze::inline v0_1::detail {

// Never constexpr: in a constant expression a bad input does not compile, and the compiler shows this call's arguments.
[[noreturn]] inline void reject(const char* argument, const char* what) {
    fail<std::domain_error>(std::string(argument) + ": " + what);
}

// What to do with a fault: reject it (in a constant expression the compiler then shows these arguments), or keep the
// first one.
struct rejecting {
    const char* argument;

    constexpr void operator()(const char* /*field*/, const char* what) const {
        if (what != nullptr) { // always
            reject(argument, what);
        }
    }
};
struct keeping_first {
    const char* argument;
    input_error* first;

    constexpr void operator()(const char* field, const char* what) const noexcept {
        if (first->what == nullptr) {
            *first = {argument, field, what};
        }
    }
};

// Whether neither radius has its sign set, by their bits; false for -0, which is then examined more closely.
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

// Tells the faults of a shape's values, in the order of its fields.
template <int N, class T, class Tell>
constexpr void inspect(const ball<N, T>& b, Tell tell) {
    if (!is_finite(b.position)) {
        tell("position", "position is not finite");
    }
    if (!is_finite(b.velocity)) {
        tell("velocity", "velocity is not finite");
    }
    if (!is_finite_input(b.radius)) {
        tell("radius", "radius is not finite");
    }
    if (split(b.radius).significand < 0) {
        tell("radius", "radius is negative");
    }
}
template <int N, class T, class Tell>
constexpr void inspect(const flight<N, T>& f, Tell tell) {
    inspect(f.state, tell);
    if (!is_finite_input(f.since)) {
        tell("since", "since is not finite");
    }
}
template <int N, class T, class Tell>
constexpr void inspect(const plane<N, T>& p, Tell tell) {
    if (!is_finite(p.point)) {
        tell("point", "point is not finite");
    }
    if (!is_finite(p.normal)) {
        tell("normal", "normal is not finite");
    }
    if (is_zero(p.normal)) {
        tell("normal", "normal is zero");
    }
}
// For a wall or a triangle, all but parallel edges, which a formula's sign decides.
template <class Edged, class Tell>
requires requires(const Edged& x) { x.edge; }
constexpr void inspect(const Edged& x, Tell tell) {
    if (!is_finite(x.corner)) {
        tell("corner", "corner is not finite");
    }
    for (const auto& e : x.edge) {
        if (!is_finite(e)) {
            tell("edge", "edge is not finite");
        }
        if (is_zero(e)) {
            tell("edge", "edge is zero");
        }
    }
}
template <class Tell>
constexpr void tell_parallel_edges(Tell tell) {
    tell("edge", "edges are parallel");
}

template <class Shape>
constexpr void check(const Shape& x, const char* argument) {
    inspect(x, rejecting{argument});
}

// How messages name two movers, and a plane, wall or triangle.
template <moving B>
inline constexpr const char* name_of_a = is_flight<B> ? "flight a" : "ball a";
template <moving B>
inline constexpr const char* name_of_b = is_flight<B> ? "flight b" : "ball b";

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
