// The contact of a ball and a plane or a wall's face, by the formulas in numbers that bound their own error.
#pragma once

#include <graze/contact/contact.hpp>
#include <graze/contact/parts.hpp>
#include <graze/formula/contact.hpp>
#include <graze/formula/impulse.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/number/bounded_word.hpp>
#include <graze/number/environment.hpp>
#include <graze/predicate/rounding_test.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

namespace graze::detail {

template <int N, class T>
[[nodiscard]] vec<N, bounded_word> as_bounded(const vec<N, T>& x) noexcept {
    return make_vec<N>([&](int i) { return bounded_word(static_cast<double>(x[i])); });
}

// A point and a normal.
template <int N, class T>
[[nodiscard]] const vec<N, T>& point_of(const plane<N, T>& p) noexcept {
    return p.point;
}
template <int N, class T>
[[nodiscard]] const vec<N, T>& point_of(const wall<N, T>& w) noexcept {
    return w.corner;
}
template <int N, class T>
[[nodiscard]] vec<N, bounded_word> face_normal_of(const plane<N, T>& p) noexcept {
    return as_bounded(p.normal);
}
template <int N, class T>
[[nodiscard]] vec<N, bounded_word> face_normal_of(const wall<N, T>& w) noexcept {
    if constexpr (N == 2) {
        return as_bounded(vec<2, T>{{-w.edge[0][1], w.edge[0][0]}});
    } else {
        return graze::cross(as_bounded(w.edge[0]), as_bounded(w.edge[1]));
    }
}

// Fills in the components of a hit that are certain and returns the others. An exact 0 is certain where no sum led to
// it; what is below 2^-500 is left open.
// clock(τ) is the time that is wanted.
template <int N, class T, class Shape, class Clock>
[[nodiscard, gnu::noinline]] parts fast_face(wall_contact<N, T>& c, const ball<N, T>& b, const Shape& shape,
                                             const Clock& clock) noexcept {
    const vec<N, bounded_word> n = face_normal_of(shape);
    const auto x = as_bounded(b.position);
    const auto u = as_bounded(b.velocity);
    const bounded_word r(static_cast<double>(b.radius));
    const plane_motion m{make_vec<N>([&](int i) {
                             return bounded_word::difference(static_cast<double>(b.position[i]),
                                                             static_cast<double>(point_of(shape)[i]));
                         }),
                         u, n, r};
    const bounded_word height = plane_height{}(m);
    const bounded_word length = sqrt(graze::squared_norm(n));
    if (!height.has_certain_sign()) {
        return all_parts;
    }
    parts certain = 0;
    const auto take = [&](const bounded_word& y, int number, T& to) {
        const ends<double> interval =
            ends_of<T>(bounded<double>{y.value().high(), y.value().low(), (1 + 0x1p-40) * y.error()});
        const bool is_zero = y.value().high() == 0 && y.error() == 0;
        const bool is_plain = absolute(interval.upper) > 0x1p-500 && agree<T>(interval);
        to = is_zero ? T(0) : is_plain ? static_cast<T>(interval.upper) : to;
        certain |= parts{is_zero || is_plain} << number;
    };
    const auto take_vector = [&](const vec<N, bounded_word>& y, wall_part first, vec<N, T>& to) {
        for (int i = 0; i < N; ++i) {
            take(y[i], static_cast<int>(first) + i, to[i]);
        }
    };
    const bounded_word time = plane_touch_time{}(height, plane_speed{}(m), r * length); // (33) completed
    const auto position = position_at(x, u, time);
    const auto normal = contact_normal(n, graze::sign(height) < 0 ? -length : length);
    take(clock(time), 0, c.time);
    take_vector(position, wall_part::position, c.position);
    take_vector(normal, wall_part::normal, c.normal);
    take_vector(position_at(position, normal, -r), wall_part::point, c.point);
    take_vector(reflected_unnormalised(u, n), wall_part::velocity, c.velocity);
    constexpr parts every_part = N == 3 ? 0x1fffU : 0xdb7U;
    return every_part & ~certain;
}

} // namespace graze::detail
