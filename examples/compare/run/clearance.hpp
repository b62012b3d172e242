// How far apart things are while they move: the second way, by which the certified run checks itself. It uses no
// discriminant, no root and nothing of formula/, only places and slopes.
#pragma once

#include "flat_shape.hpp"

#include <graze/formula/relative_motion.hpp>
#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <array>

namespace compare::run {

// value: the squared distance between a centre and what it may touch, less the squared distance of a touch. slope: half
// of value's derivative in time. value is a convex function of time, since the other thing is convex and moves
// uniformly. For a plane both are times n·n.
struct clearance {
    certified value, slope;
};

template <int N>
using vector_of = graze::vec<N, certified>;

template <int N>
[[nodiscard]] vector_of<N> place_at(const graze::flight<N, certified>& a, const certified& t) {
    return a.state.position + (t - a.since) * a.state.velocity;
}

// The point of a wall, a triangle or a segment that is nearest to x.
template <int N>
[[nodiscard]] vector_of<N> nearest_point(const graze::wall<N, certified>& w, const vector_of<N>& x);
template <int N>
[[nodiscard]] vector_of<N> nearest_point(const graze::triangle<certified>& t, const vector_of<N>& x);
template <int N>
[[nodiscard]] vector_of<N> nearest_on_segment(const vector_of<N>& corner, const vector_of<N>& edge,
                                              const vector_of<N>& x);

template <int N>
[[nodiscard]] clearance clearance_at(const graze::flight<N, certified>& a, const graze::flight<N, certified>& b,
                                     const certified& t) {
    const vector_of<N> apart = place_at(a, t) - place_at(b, t);
    const certified reach = a.state.radius + b.state.radius;
    return {graze::squared_norm(apart) - reach * reach, graze::dot(apart, a.state.velocity - b.state.velocity)};
}
template <int N>
[[nodiscard]] clearance clearance_at(const graze::flight<N, certified>& a, const graze::plane<N, certified>& p,
                                     const certified& t) {
    const certified height = graze::dot(place_at(a, t) - p.point, p.normal), &r = a.state.radius;
    return {height * height - r * r * graze::squared_norm(p.normal), height * graze::dot(a.state.velocity, p.normal)};
}
template <int N, flat_shape W>
[[nodiscard]] clearance clearance_at(const graze::flight<N, certified>& a, const W& w, const certified& t) {
    const vector_of<N> x = place_at(a, t), apart = x - nearest_point<N>(w, x);
    return {graze::squared_norm(apart) - a.state.radius * a.state.radius, graze::dot(apart, a.state.velocity)};
}

// Whether a clearance stays above 0 strictly between two instants. crossed: certainly not. open: unknown.
enum class verdict { clear, crossed, open };

// of: the clearance at a time. touches_at_end: it may be 0 at `to`, since that is an event.
template <class Of>
[[nodiscard]] verdict clear_between(Of of, const certified& from, const certified& to, bool touches_at_end);

// The same from an instant on, for ever.
template <class Of>
[[nodiscard]] verdict clear_after(Of of, const certified& from);

// An enclosure of the first time at which it is 0 or, if it is not certainly 0 at any, at which it is least; at most
// `to`, if given.
template <class Of>
[[nodiscard]] certified first_touch(Of of, const certified& from, const certified* to);

// The templates above.

[[nodiscard]] inline certified magnitude(const certified& x) { return larger(x, -x); }

// A convex function is above its tangents: first those at the ends are tried and, if they do not tell, one at an
// instant between them.
template <class Of>
verdict clear_between(Of of, const certified& from, const certified& to, bool touches_at_end) {
    certified lower = from, length = to - from;
    const std::optional<int> order = length.certain_sign();
    if (order == 0) {
        return verdict::clear;
    }
    clearance first = of(from);
    const std::optional<int> leaving = first.slope.certain_sign();
    if (leaving && *leaving >= 0) { // it grows; that it was not below 0 was checked before
        return verdict::clear;
    }
    const auto holds_around = [&](const clearance& c) {
        return (c.value - certified(2) * magnitude(c.slope) * magnitude(length)).certain_sign() == 1;
    };
    if (holds_around(first)) {
        return verdict::clear;
    }
    clearance last = of(to);
    const std::optional<int> arriving = last.slope.certain_sign();
    if (arriving && *arriving <= 0) { // it shrinks to its value at the end
        const std::optional<int> end = last.value.certain_sign();
        const bool shrinks = *arriving < 0 || leaving == -1 || first.value.certain_sign() == 1;
        return end ? (*end >= 0               ? verdict::clear
                      : order == 1 && shrinks ? verdict::crossed
                                              : verdict::open)
                   : (touches_at_end ? verdict::clear : verdict::open);
    }
    if (!leaving || !arriving || order != 1) {
        return holds_around(last) ? verdict::clear : verdict::open;
    }
    for (int i = 0; i < 200; ++i) {
        const certified where = (last.value - certified(2) * last.slope * length - first.value) /
                                (certified(2) * (first.slope - last.slope)); // the tangents meet so long after lower
        if ((first.value + certified(2) * first.slope * where).certain_sign() == 1) {
            return verdict::clear;
        }
        const double part = near_double(where / length);
        const int share = part > 1 / 64. && part < 63 / 64. ? static_cast<int>(part * 64) : 32;
        const certified step = length * certified(exact(share, 64), length.bits()), at = lower + step;
        clearance middle = of(at);
        if (const std::optional<int> sign = middle.value.certain_sign(); sign && *sign <= 0) {
            return verdict::crossed;
        }
        const std::optional<int> sign = middle.slope.certain_sign();
        if (!sign || *sign == 0) {
            return holds_around(middle) ? verdict::clear : verdict::open;
        }
        if (*sign < 0) {
            lower = at;
            length = length - step;
            first = std::move(middle);
        } else {
            length = step;
            last = std::move(middle);
        }
    }
    return verdict::open;
}

template <class Of>
verdict clear_after(Of of, const certified& from) {
    certified length(exact(1), from.bits());
    for (int i = 0; i < 1100; ++i, length = length + length) {
        const clearance then = of(from + length);
        const std::optional<int> leaving = then.slope.certain_sign(), beyond = then.value.certain_sign();
        if (leaving && *leaving >= 0) {
            return clear_between(of, from, from + length, false);
        }
        if (leaving && beyond == -1) {
            const std::optional<int> at_start = of(from).slope.certain_sign();
            return !at_start ? verdict::open : *at_start >= 0 ? verdict::clear : verdict::crossed;
        }
    }
    return verdict::open;
}

template <class Of>
certified first_touch(Of of, const certified& from, const certified* to) {
    constexpr int halvings = 64;
    constexpr long bits = 2 * halvings;
    const auto grows = [](const clearance& c) { return c.slope.certain_sign().value_or(1) >= 0; };
    const auto is_touched = [](const clearance& c) { return c.value.certain_sign().value_or(1) <= 0; };
    certified lower = from, upper = to != nullptr ? *to : from + certified(exact(1), from.bits());
    for (int i = 0; to == nullptr && i < 1100 && !grows(of(upper)); ++i) {
        upper = upper + (upper - from);
    }
    // Halves [lower, upper] so that it keeps the first instant at which `holds` is true; from there on it stays true.
    const auto halve = [&](auto holds) {
        const certified middle = (lower + upper) * certified(exact(1, 2), from.bits());
        (holds(of(middle)) ? upper : lower) = middle;
    };
    const auto touches = [&](const clearance& c) { return is_touched(c) || grows(c); };
    for (int i = 0; i < halvings; ++i) {
        halve(touches);
    }
    return either(lower.at(bits), upper.at(bits));
}

} // namespace compare::run
