// Names bad input in a scene: which part, which field, what is wrong.
#pragma once

#include <graze/pair/input_check.hpp>
#include <graze/pair/pair.hpp>
#include <graze/scene/scene.hpp>

#include <string>

namespace graze::inline v0_1 {

namespace detail {

// Whether x is a number and not infinite: only then is x - x 0.
template <number T>
[[nodiscard]] constexpr bool is_finite_number(const T& x) {
    if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>) {
        return is_finite_input(x);
    } else {
        return T(x - x) == T(0);
    }
}
template <int N, class T>
[[nodiscard]] constexpr bool is_finite_vector(const vec<N, T>& x) {
    for (int i = 0; i < N; ++i) {
        if (!is_finite_number(x[i])) {
            return false;
        }
    }
    return true;
}
template <int N, class T>
[[nodiscard]] constexpr bool is_zero_vector(const vec<N, T>& x) {
    for (int i = 0; i < N; ++i) {
        if (graze::sign(x[i]) != 0) {
            return false;
        }
    }
    return true;
}

// The fault of a ball, or nullptr.
template <int N, class T>
[[nodiscard]] constexpr const char* fault_of(const ball<N, T>& b) {
    return !is_finite_vector(b.position)   ? "position is not finite"
           : !is_finite_vector(b.velocity) ? "velocity is not finite"
           : !is_finite_number(b.radius)   ? "radius is not finite"
           : graze::sign(b.radius) < 0     ? "radius is negative"
           : graze::sign(b.mass) <= 0      ? "mass is not positive"
                                           : nullptr;
}
template <int N, class T>
[[nodiscard]] constexpr const char* fault_of(const plane<N, T>& p) {
    return !is_finite_vector(p.point)    ? "point is not finite"
           : !is_finite_vector(p.normal) ? "normal is not finite"
           : is_zero_vector(p.normal)    ? "normal is zero"
                                         : nullptr;
}
// For a wall or a triangle, all but parallel edges, which the sign of a formula decides that T may round.
template <class W>
requires requires(const W& w) { w.edge; }
[[nodiscard]] constexpr const char* fault_of(const W& w) {
    if (!is_finite_vector(w.corner)) {
        return "corner is not finite";
    }
    for (const auto& e : w.edge) {
        if (!is_finite_vector(e)) {
            return "edge is not finite";
        }
        if (is_zero_vector(e)) {
            return "edge is zero";
        }
    }
    return nullptr;
}

// fault(part): the fault of a part, or nullptr.
template <class Part, class Fault>
void check_parts(std::span<const Part> pieces, const char* kind, Fault fault) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (const char* found = fault(pieces[i])) {
            reject((kind + std::to_string(i)).c_str(), found);
        }
    }
}

// The fault of a part in a space that repeats itself after a length along an axis, or nullptr.
template <int N, class T>
[[nodiscard]] constexpr const char* fault_in_period(const ball<N, T>& b, const T& length, int) {
    return b.radius < T(length - b.radius) ? nullptr : "diameter reaches the period";
}
template <int N, class T>
[[nodiscard]] constexpr const char* fault_in_period(const plane<N, T>& p, const T&, int axis) {
    return graze::sign(p.normal[axis]) == 0 ? nullptr : "normal has a component along a period";
}
// For a wall or a triangle.
template <class W, class T>
requires requires(const W& w) { w.edge; }
[[nodiscard]] constexpr const char* fault_in_period(const W& w, const T& length, int axis) {
    T low(0), high(0);
    for (const auto& e : w.edge) {
        const T& x = e[axis];
        if constexpr (is_triangle<W>) {
            low = x < low ? x : low;
            high = high < x ? x : high;
        } else {
            (graze::sign(x) < 0 ? low : high) = T((graze::sign(x) < 0 ? low : high) + x);
        }
    }
    return length < T(high - low) ? "longer than the period" : nullptr;
}
template <int N, class T, class Fault>
void check_all_parts(const scene<N, T>& s, Fault fault) {
    check_parts(s.balls, "ball ", fault);
    check_parts(s.planes, "plane ", fault);
    check_parts(s.walls, "wall ", fault);
    check_parts(triangles_of(s), "triangle ", fault);
}

template <int N, class T>
[[nodiscard]] constexpr bool is_periodic(const scene<N, T>& s) {
    return !is_zero_vector(s.period);
}

} // namespace detail

// Throws std::domain_error that names the first part at fault ("ball 17: radius is negative"): a NaN or an infinity
// anywhere but in a mass, a negative radius, a mass that is not positive, a zero normal, a zero edge, or marks of inner
// edges that no triangle has; a negative period, and along one a ball as wide as it, a normal with a component, a
// longer wall or triangle ("wall 2: longer than the period").
template <int N, class T>
void check(const scene<N, T>& s) {
    detail::check_all_parts(s, [](const auto& part) { return detail::fault_of(part); });
    const auto marks = detail::inner_edges_of(s);
    if (!marks.empty() && marks.size() != detail::triangles_of(s).size()) {
        detail::reject("inner_edges", "not one for each triangle");
    }
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i] > 7) {
            detail::reject(("inner_edges of triangle " + std::to_string(i)).c_str(), "a triangle has three edges");
        }
    }
    for (int i = 0; i < N; ++i) {
        if (!detail::is_finite_number(s.period[i]) || graze::sign(s.period[i]) < 0) {
            detail::reject("period", "not a finite number from 0 on");
        }
        if (graze::sign(s.period[i]) > 0) {
            detail::check_all_parts(s, [&](const auto& part) { return detail::fault_in_period(part, s.period[i], i); });
        }
    }
}

} // namespace graze::inline v0_1
