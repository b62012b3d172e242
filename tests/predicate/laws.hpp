// The laws, which hold for every pair and every answer.
#pragma once

#include "../property.hpp"
#include "answers.hpp"
#include "transform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace laws {

// 1. The axes may be permuted and mirrored.
template <class A, class B>
void axes(const A& a, const B& b, bool mirror = true) {
    const auto answer = answers::of(a, b);
    PROPERTY_ASSERT(answers::of(transform::permuted(a, 1), transform::permuted(b, 1)) == answer);
    if (mirror) {
        const unsigned which = property::in_range(1U, 8U);
        PROPERTY_ASSERT(answers::of(transform::reflected(a, which), transform::reflected(b, which)) == answer);
    }
}

// x + y, if that is exact.
template <int N>
bool add_exactly(graze::vec<N, double>& x, const graze::vec<N, double>& y) {
    for (int i = 0; i < N; ++i) {
        const double sum = x[i] + y[i];
        if (!std::isfinite(sum) || mpq_class(sum) != mpq_class(x[i]) + mpq_class(y[i])) {
            return false;
        }
        x[i] = sum;
    }
    return true;
}

// 2. The same things may be written differently: balls exchanged, a plane's normal reversed, a wall's edges exchanged
// or drawn from the other end.
template <int N, class T>
void presentation(const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
    PROPERTY_ASSERT(answers::of(a, b) == answers::of(b, a));
}
template <int N, class T>
void presentation(const graze::ball<N, T>& a, graze::plane<N, T> p) {
    const auto answer = answers::of(a, p);
    p.normal = -p.normal;
    PROPERTY_ASSERT(answers::of(a, p) == answer);
}
template <int N, class T>
void presentation(const graze::ball<N, T>& a, graze::wall<N, T> w) {
    const auto answer = answers::of(a, w);
    std::swap(w.edge.front(), w.edge.back());
    PROPERTY_ASSERT(answers::of(a, w) == answer);
    if constexpr (std::is_same_v<T, double>) {
        if (add_exactly(w.corner, w.edge[0])) {
            w.edge[0] = -w.edge[0];
            PROPERTY_ASSERT(answers::of(a, w) == answer);
        }
    }
}

// A triangle's corners may come in another order.
template <class T>
void presentation(const graze::ball<3, T>& a, graze::triangle<T> t) {
    const auto answer = answers::of(a, t);
    std::swap(t.edge[0], t.edge[1]);
    PROPERTY_ASSERT(answers::of(a, t) == answer);
    graze::vec<3, T> third = t.edge[1];
    if (add_exactly(t.corner, t.edge[0]) && add_exactly(third, -t.edge[0])) {
        t.edge = {third, -t.edge[0]};
        PROPERTY_ASSERT(answers::of(a, t) == answer);
    }
}

// x 2^power is exact and no bit of it is lost.
inline bool scales(double x, int power) { return x == 0 || std::ldexp(std::ldexp(x, power), -power) == x; }

// 3. Lengths, velocities and normals may be scaled by a power of two each: the encounter stays and times scale.
template <class A, class B>
void scaling(const A& a, const B& b) {
    const int power[3] = {property::in_range(-300, 301), property::in_range(-300, 301), property::in_range(-300, 301)};
    bool exact = true;
    const auto times = [&](double x, int kind) {
        exact = exact && scales(x, power[kind]);
        return std::ldexp(x, power[kind]);
    };
    const A scaled_a = transform::scaled(a, times);
    const B scaled_b = transform::scaled(b, times);
    if (!exact) {
        return; // not counted: most pairs are far from the ends of the range
    }
    const auto answer = answers::of(a, b);
    const auto scaled = answers::of(scaled_a, scaled_b);
    PROPERTY_ASSERT(scaled.what == answer.what);
    PROPERTY_ASSERT(scaled.overlaps == answer.overlaps);
    PROPERTY_ASSERT(scaled.time.has_value() == answer.time.has_value());
    if (answer.time) {
        const double m = oracle::nearest_double(*oracle::meet(a, b).time);
        const int unit = power[0] - power[1];
        if (std::isfinite(m) && scales(m, unit)) {
            PROPERTY_ASSERT(answers::order_of(*scaled.time, std::ldexp(m, unit)) == answers::order_of(*answer.time, m));
        }
    }
}

// 4. Both balls may fly faster by the same velocity, and everything may be elsewhere. Returns whether that was exact.
template <int N>
bool common_velocity(graze::ball<N, double> a, graze::ball<N, double> b, const graze::vec<N, double>& v) {
    const auto answer = answers::of(a, b);
    if (!add_exactly(a.velocity, v) || !add_exactly(b.velocity, v)) {
        return false;
    }
    PROPERTY_ASSERT(answers::of(a, b) == answer);
    return true;
}
template <int N>
bool common_position(graze::ball<N, double> a, graze::ball<N, double> b, const graze::vec<N, double>& x) {
    const auto answer = answers::of(a, b);
    if (!add_exactly(a.position, x) || !add_exactly(b.position, x)) {
        return false;
    }
    PROPERTY_ASSERT(answers::of(a, b) == answer);
    return true;
}

// 5. All times are in one order, whatever pair they are of: exactly one of <, == and > holds, exchanging the operands
// exchanges it, and < is transitive.
template <int N>
void order(const std::optional<graze::impact_time<N, double>>& x, const std::optional<graze::impact_time<N, double>>& y,
           const std::optional<graze::impact_time<N, double>>& z) {
    if (x && y && z) {
        const int xy = answers::order_of(*x, *y);
        const int yz = answers::order_of(*y, *z);
        PROPERTY_ASSERT(xy == -answers::order_of(*y, *x));
        PROPERTY_ASSERT(answers::order_of(*x, *x) == 0);
        PROPERTY_ASSERT(xy > 0 || yz > 0 || answers::order_of(*x, *z) == std::min(xy, yz));
    }
}

// 6. overlap, graze and hit have a time, recede and miss have none; an overlap's time is 0.
template <class A, class B>
void collisions_have_times(const A& a, const B& b) {
    const auto answer = answers::of(a, b);
    PROPERTY_ASSERT(answer.time.has_value() == graze::is_collision(answer.what));
    PROPERTY_ASSERT(answer.what != graze::encounter::overlap || answers::order_of(*answer.time, 0.0) == 0);
}

// 7. A plane is never missed and never grazed.
template <int N, class T>
void planes_are_met(const graze::ball<N, T>& a, const graze::plane<N, T>& p) {
    const auto what = answers::of(a, p).what;
    PROPERTY_ASSERT(what != graze::encounter::miss && what != graze::encounter::graze);
}

// 8. A wall is met no earlier than its plane, if both are met. In the plane, where normals are doubles.
inline void walls_lie_in_planes(const graze::ball<2, double>& a, const graze::wall<2, double>& w) {
    const graze::plane<2, double> p{w.corner, {-w.edge[0][1], w.edge[0][0]}};
    const auto wall = answers::of(a, w);
    const auto plane = answers::of(a, p);
    PROPERTY_ASSERT(!wall.time || !plane.time || answers::order_of(*plane.time, *wall.time) <= 0);
}

// 9. A larger ball is met no later.
template <int N>
void larger_is_earlier(graze::ball<N, double> a, const graze::ball<N, double>& b) {
    const auto answer = answers::of(a, b);
    a.radius = property::one_of(std::nextafter(a.radius, std::numeric_limits<double>::infinity()), a.radius * 1.5);
    if (answer.time && std::isfinite(a.radius)) {
        const auto larger = answers::of(a, b);
        PROPERTY_ASSERT(larger.time.has_value());
        PROPERTY_ASSERT(answers::order_of(*larger.time, *answer.time) <= 0);
    }
}

// 10. classify says overlap if and only if the pair overlaps and does not recede.
template <class A, class B>
void overlap_is_now(const A& a, const B& b) {
    const auto answer = answers::of(a, b);
    PROPERTY_ASSERT((answer.what == graze::encounter::overlap) ==
                    (answer.overlaps && answer.what != graze::encounter::recede));
}

// 11. Numbers stand in the same order as times.
template <int N>
void numbers_in_order(const std::optional<graze::impact_time<N, double>>& x,
                      const std::optional<graze::impact_time<N, double>>& y) {
    if (x && y) {
        const double lower = x->lower(), upper = x->upper();
        PROPERTY_ASSERT(answers::order_of(*x, lower) >= 0 && answers::order_of(*x, upper) <= 0);
        PROPERTY_ASSERT((answers::order_of(*x, lower) == 0) == (lower == upper));
        PROPERTY_ASSERT(answers::order_of(*y, upper) <= 0 || answers::order_of(*x, *y) < 0);
        PROPERTY_ASSERT(answers::order_of(*y, lower) >= 0 || answers::order_of(*x, *y) > 0);
    }
}

// 16. A wall is met when the first of its two triangles is, with the same encounter. Returns whether its corners are
// exact and the ball is outside.
inline bool halves_make_a_wall(const graze::ball<3, double>& a, const graze::wall<3, double>& w) {
    graze::triangle<double> half{w.corner, w.edge}, other{w.corner, {-w.edge[0], -w.edge[1]}};
    const auto wall = answers::of(a, w);
    auto larger = a;
    larger.radius = std::nextafter(a.radius, std::numeric_limits<double>::infinity());
    auto by = graze::stage::filter;
    if (answers::overlap_of(larger, w, by) || !add_exactly(other.corner, w.edge[0]) ||
        !add_exactly(other.corner, w.edge[1])) {
        return false;
    }
    const auto x = answers::of(a, half), y = answers::of(a, other);
    const bool x_first = x.time && (!y.time || answers::order_of(*x.time, *y.time) <= 0);
    const auto& first = x_first ? x : y;
    PROPERTY_ASSERT(wall.time.has_value() == first.time.has_value());
    PROPERTY_ASSERT(!wall.time || (answers::order_of(*wall.time, *first.time) == 0 && wall.what == first.what));
    return true;
}

} // namespace laws
