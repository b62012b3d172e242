// The results of graze::solve in an exact number type T, against the oracle and against the laws of physics.
#pragma once

#include "../oracle/contact.hpp"
#include "../property.hpp"
#include "draw.hpp"

#include <graze/solve.hpp>

#include <doctest/doctest.h>

#include <string>

namespace exact {

template <class T, int N>
graze::vec<N, T> in(const graze::vec<N, int>& x) {
    return graze::make_vec<N>([&](int i) { return T(x[i]); });
}
template <class T, int N>
graze::ball<N, T> in(const graze::ball<N, int>& b) {
    return {in<T>(b.position), in<T>(b.velocity), T(b.radius), T(b.mass)};
}
template <class T, int N>
graze::plane<N, T> in(const graze::plane<N, int>& p) {
    return {in<T>(p.point), in<T>(p.normal)};
}
template <class T, int N>
graze::wall<N, T> in(const graze::wall<N, int>& w) {
    graze::wall<N, T> wall{in<T>(w.corner), {}};
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        wall.edge[i] = in<T>(w.edge[i]);
    }
    return wall;
}

// Each exact type defines rational_in(x), its value.
template <class T>
bool equal(const graze::sqrt_extension<T>& x, const oracle::surd& y) {
    const mpq_class p = rational_in(x.p()), q = rational_in(x.q()), d = rational_in(x.d());
    const oracle::surd root = oracle::square_root(d);
    return oracle::compare(oracle::rational(p) + oracle::rational(q) * root, y) == 0;
}

template <class R, int N>
bool equal(const graze::vec<N, R>& x, const oracle::surd_vector<N>& y) {
    for (int i = 0; i < N; ++i) {
        if (!equal(x[i], y[i])) {
            return false;
        }
    }
    return true;
}

// For whole inputs, which the oracle does not scale.
template <class T>
bool has_discriminant(const T& x, const oracle::piece& p) {
    return equal(graze::root_type<T>(x), oracle::rational(p.discriminant()));
}

inline graze::encounter as_library(oracle::encounter e) { return static_cast<graze::encounter>(e); }

// The sums of m v and of m v² over both balls do not change; the masses are given by their inverses.
template <class T, int N>
void check_conservation(const graze::ball<N, T>& a, const graze::ball<N, T>& b, const graze::ball_solution<N, T>& s) {
    using R = graze::root_type<T>;
    const R ma(a.mass), mb(b.mass);
    const R zero(0);
    R energy = zero;
    for (int i = 0; i < N; ++i) {
        const R ua(a.velocity[i]), ub(b.velocity[i]);
        PROPERTY_ASSERT(graze::sign(R(ma * (s.velocity_a[i] - ua) + mb * (s.velocity_b[i] - ub))) == 0);
        energy = energy + ma * (s.velocity_a[i] * s.velocity_a[i] - ua * ua) +
                 mb * (s.velocity_b[i] * s.velocity_b[i] - ub * ub);
    }
    PROPERTY_ASSERT(graze::sign(energy) == 0);
}

// The same in another variant or root form, which may write the same time over another root.
template <int N, class T>
void same(const graze::ball_solution<N, T>& s, const graze::ball_solution<N, T>& t) {
    PROPERTY_ASSERT(s.what == t.what);
    PROPERTY_ASSERT(graze::sign(T(s.discriminant - t.discriminant)) == 0);
}

// Checks everything that is claimed of a pair of balls.
template <class T, int N>
graze::encounter check(const graze::ball<N, int>& whole_a, const graze::ball<N, int>& whole_b) {
    using enum graze::variant;
    using graze::root_form;
    const auto a = in<T>(whole_a);
    const auto b = in<T>(whole_b);
    const auto s = graze::solve(a, b);
    const oracle::answer met = oracle::meet(whole_a, whole_b);
    PROPERTY_ASSERT(s.what == as_library(met.what));
    PROPERTY_ASSERT(has_discriminant(s.discriminant, met.pieces[0]));

    const auto by_textbook = graze::solve<textbook, root_form::stable>(a, b);
    const auto printed = graze::solve<halved, root_form::printed>(a, b);
    same(s, by_textbook);
    same(s, printed);
    const auto q = graze::quadratic_of(graze::relative_motion_of(a, b));
    PROPERTY_ASSERT(graze::sign(T(graze::discriminant_textbook{}(q)-T(4) * graze::discriminant_halved{}(q))) == 0);

    if (graze::is_collision(s.what)) {
        const auto c = oracle::contact(whole_a, whole_b, mpq_class(1, whole_a.mass), mpq_class(1, whole_b.mass), met);
        PROPERTY_ASSERT(equal(s.time, c.time));
        PROPERTY_ASSERT(equal(by_textbook.time, c.time));
        PROPERTY_ASSERT(equal(printed.time, c.time));
        PROPERTY_ASSERT(equal(printed.velocity_b, c.velocity_b));
        PROPERTY_ASSERT(equal(s.position_a, c.position_a));
        PROPERTY_ASSERT(equal(s.position_b, c.position_b));
        PROPERTY_ASSERT(equal(s.normal, c.normal));
        PROPERTY_ASSERT(equal(s.velocity_a, c.velocity_a));
        PROPERTY_ASSERT(equal(s.velocity_b, c.velocity_b));
        check_conservation(a, b, s);

        const auto swapped = graze::solve(b, a);
        PROPERTY_ASSERT(swapped.what == s.what);
        PROPERTY_ASSERT(swapped.time == s.time);
        PROPERTY_ASSERT(swapped.normal == -s.normal);
        PROPERTY_ASSERT(swapped.position_a == s.position_b);
        PROPERTY_ASSERT(swapped.velocity_a == s.velocity_b);
        PROPERTY_ASSERT(swapped.velocity_b == s.velocity_a);

        // If a has an infinite mass, it does not move.
        const auto fixed = graze::solve_with_inverse_masses(a, b, T(0), T(T(1) / b.mass));
        const auto d = oracle::contact(whole_a, whole_b, 0, mpq_class(1, whole_b.mass), met);
        PROPERTY_ASSERT(equal(fixed.velocity_a, d.velocity_a));
        PROPERTY_ASSERT(equal(fixed.velocity_b, d.velocity_b));
    }
    return s.what;
}

template <int N, class T>
void check_wall_contact(const graze::wall_solution<N, T>& s, const oracle::wall_contact<N>& c) {
    PROPERTY_ASSERT(equal(s.time, c.time));
    PROPERTY_ASSERT(equal(s.position, c.position));
    PROPERTY_ASSERT(equal(s.point, c.point));
    PROPERTY_ASSERT(equal(s.normal, c.normal));
    PROPERTY_ASSERT(equal(s.velocity, c.velocity));
}

template <class T, int N>
graze::encounter check(const graze::ball<N, int>& ball, const graze::plane<N, int>& plane) {
    const auto s = graze::solve(in<T>(ball), in<T>(plane));
    const oracle::answer met = oracle::meet(ball, plane);
    PROPERTY_ASSERT(s.what == as_library(met.what));
    if (graze::is_collision(s.what)) {
        check_wall_contact(s, oracle::contact(ball, plane, met));
    }
    return s.what;
}

template <class T, int N>
graze::wall_solution<N, T> check(const graze::ball<N, int>& ball, const graze::wall<N, int>& wall) {
    const auto s = graze::solve(in<T>(ball), in<T>(wall));
    const oracle::answer met = oracle::meet(ball, wall);
    PROPERTY_ASSERT(s.what == as_library(met.what));
    if (s.what != graze::encounter::miss) {
        PROPERTY_ASSERT(s.where == static_cast<graze::feature>(met.where()));
        PROPERTY_ASSERT(met.has(met.where(), s.index));
    }
    if (graze::is_collision(s.what)) {
        check_wall_contact(s, oracle::contact(ball, wall, met, met.where(), s.index));
        if (s.where != graze::feature::face) {
            PROPERTY_ASSERT(has_discriminant(s.discriminant, met.piece_of(met.where(), s.index)));
        }
    }
    return s;
}

// The whole suite for T.
template <class T>
void check_all() {
    static_assert(graze::exact_number<T> && graze::field_number<T>);
    CHECK(property::check("two balls in the plane", [] { check<T>(draw::ball<2>(), draw::ball<2>()); }));
    CHECK(property::check("two balls in space", [] { check<T>(draw::ball<3>(), draw::ball<3>()); }));
    CHECK(property::check("ball and line", [] { check<T>(draw::ball<2>(), draw::plane<2>()); }));
    CHECK(property::check("ball and plane", [] { check<T>(draw::ball<3>(), draw::plane<3>()); }));
    CHECK(property::check("ball and segment", [] {
        const auto pair = draw::ball_with_wall<2>();
        check<T>(pair.ball, pair.wall);
    }));
    CHECK(property::check("ball and parallelogram", [] {
        const auto pair = draw::ball_with_wall<3>();
        check<T>(pair.ball, pair.wall);
    }));
}

} // namespace exact
