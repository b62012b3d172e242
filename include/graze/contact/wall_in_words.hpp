// The contact of a ball and a plane or a wall, by the formulas in numbers that bound their own error.
#pragma once

#include <graze/contact/components.hpp>
#include <graze/contact/contact.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/formula/solution.hpp>
#include <graze/time/hit_time.hpp>

namespace graze::inline v0_1::detail {

// Takes numbers and writes those whose rounding is certain. An exact 0 is certain if no rounding led to it; all else
// below 2^-500 is left open.
template <int N, class T>
class rounded_words {
  public:
    void operator()(const bounded_word& y, int number, T& to) noexcept {
        const ends<double> interval = ends_of<T>(as_bounds(y));
        const bool is_plain = absolute(interval.upper) > 0x1p-500 && agree<T>(interval);
        to = y.is_zero() ? T(0) : is_plain ? static_cast<T>(interval.upper) : to;
        certain_ |= component_set{y.is_zero() || is_plain} << number;
    }
    void operator()(const vec<N, bounded_word>& y, wall_component first, vec<N, T>& to) noexcept {
        for (int i = 0; i < N; ++i) {
            (*this)(y[i], static_cast<int>(first) + i, to[i]);
        }
    }
    void keep(component_set known) noexcept { certain_ |= known; }
    [[nodiscard]] component_set open_components() const noexcept { return (N == 3 ? 0x1fffU : 0xdb7U) & ~certain_; }

  private:
    component_set certain_ = 0;
};

// A hit on a plane or a wall's face, or an overlap. x: the ball's position; clock(τ): the time that is wanted.
template <int N, class T, class M, class Clock>
void take_face(rounded_words<N, T>& take, wall_contact<N, T>& c, encounter what, const M& m,
               const vec<N, bounded_word>& x, const Clock& clock) noexcept {
    const bounded_word height = plane_height{}(m);
    const bounded_word square = graze::squared_norm(m.n);
    if (!height.has_certain_sign()) {
        return;
    }
    const bounded_word length = sqrt(square);
    const auto normal = contact_normal(m.n, graze::sign(height) < 0 ? -length : length);
    take(normal, wall_component::normal, c.normal);
    take(reflected_unnormalised(m.u, m.n), wall_component::velocity, c.velocity);
    if (what == encounter::overlap) {
        take(position_at(x, m.n, -(height / square)), wall_component::point, c.point);
        return;
    }
    const bounded_word time = face_time(m);
    const auto position = position_at(x, m.u, time);
    take(clock(time), 0, c.time);
    take(position, wall_component::position, c.position);
    take(position_at(position, normal, -m.r), wall_component::point, c.point);
}

// An edge or a corner. m: seen from the view in which it is the first one. time: 0 for an overlap.
template <int N, class T, class M, class Clock>
void take_feature(rounded_words<N, T>& take, wall_contact<N, T>& c, encounter what, const M& m,
                  const bounded_word& time, const vec<N, bounded_word>& x, const Clock& clock) noexcept {
    vec<N, bounded_word> apart = position_at(m.w, m.u, time);
    vec<N, bounded_word> point = x - m.w;
    if constexpr (N == 3) {
        if (c.feature == feature::edge) {
            const bounded_word along = graze::dot(apart, m.e[1]) / graze::squared_norm(m.e[1]);
            point = position_at(point, m.e[1], along);
            apart = position_at(apart, m.e[1], -along);
        }
    }
    take(point, wall_component::point, c.point);
    if (what != encounter::overlap) {
        take(clock(time), 0, c.time);
        take(position_at(x, m.u, time), wall_component::position, c.position);
    }
    const bool inside = what == encounter::overlap;
    const vec<N, bounded_word> normal = m.r.is_zero() && !inside
                                            ? zero_vector<N, bounded_word>()
                                            : contact_normal(apart, inside ? sqrt(graze::squared_norm(apart)) : m.r);
    take(normal, wall_component::normal, c.normal);
    if (what != encounter::graze) {
        take(inside ? reflected_unnormalised(m.u, apart) : reflected(m.u, normal), wall_component::velocity,
             c.velocity);
    }
}

// Fills in the components that are certain and returns the others. The caller has set the position of an overlap and
// the velocity of a graze.
template <class P, int N, class T, class Shape, class Clock>
[[nodiscard, gnu::noinline]] component_set wall_in_words(P, wall_contact<N, T>& c, encounter what, int index,
                                                         const ball<N, T>& b, const Shape& shape,
                                                         const Clock& clock) noexcept {
    constexpr component_set vector = 7;
    rounded_words<N, T> take;
    if (what == encounter::overlap) {
        take(clock(bounded_word(0)), 0, c.time);
        take.keep(vector << static_cast<int>(wall_component::position));
    } else if (what == encounter::graze) {
        take.keep(vector << static_cast<int>(wall_component::velocity));
    }
    const auto row = packed<P>(b, shape);
    const auto m = bounded_motion(P{}, row.data());
    const auto x = make_vec<N>(
        [&](int i) { return bounded_group<T>{row.data()}.template get<bounded_word>(static_cast<std::size_t>(i)); });
    if constexpr (std::is_same_v<P, ball_and_plane<N>>) {
        take_face(take, c, what, m, x, clock);
    } else if (c.feature == feature::face) {
        take_face(take, c, what, face_of(m), x, clock);
    } else {
        const auto when = [&](const auto& q, const auto& discriminant) {
            return what == encounter::overlap ? bounded_word(0)
                   : what == encounter::graze ? bounded_word(root_of_graze{}(q.a, q.h))
                                              : root_time(q, discriminant());
        };
        if constexpr (N == 3) {
            if (c.feature == feature::edge) {
                const auto view = seen_from(m, edge_view(index));
                const auto time = when(edge_quadratic(view), [&] { return edge_discriminant{}(view); });
                take_feature(take, c, what, view, time, x, clock);
                return take.open_components();
            }
        }
        const auto view = seen_from(m, wall_view{index, false});
        const auto relative = corner_motion(view);
        const auto time = when(quadratic_of(relative), [&] { return discriminant_lagrange{}(relative); });
        take_feature(take, c, what, view, time, x, clock);
    }
    return take.open_components();
}

} // namespace graze::inline v0_1::detail
