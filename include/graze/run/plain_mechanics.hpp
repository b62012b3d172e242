// A run in any number type, by the formulas as they are.
#pragma once

#include <graze/exact/dyadic.hpp>
#include <graze/formula/solve_balls.hpp>
#include <graze/formula/solve_flat.hpp>
#include <graze/formula/solve_plane.hpp>
#include <graze/scene/mechanics.hpp>

#include <limits>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1 {

// Predictions and contacts in T by the formulas of `solve`, in variant V and root form F, each operation with T's own
// error: nothing is promised about decisions, order or states. If two balls have different epochs, the earlier one is
// first advanced to the later epoch, in T.
template <int N, number T, variant V = variant::halved, root_form F = root_form::stable>
requires field_number<T> && has_sqrt<T> && has_variant<V, T>
struct plain_mechanics {
    static constexpr int dimension = N;
    using number = T;
    using state = flight<N, T>;
    using time = T;
    using exact = std::conditional_t<is_binary_input<T>, dyadic, T>;
    static constexpr bool rounds = !number_traits<T>::is_exact;

    [[nodiscard]] constexpr state start(const ball<N, T>& b) const { return {b, T(0)}; }

    [[nodiscard]] constexpr std::optional<T> meet(const state& a, const state& b) const {
        const T from = later(a, b);
        const auto m = relative_motion_of(ball_at(a, from), ball_at(b, from));
        return first_time(m, from, [&](const quadratic<T, T, T>& q) {
            return T(detail::discriminant_by<V, T>(q, [&] { return T(discriminant_lagrange{}(m)); }));
        });
    }
    [[nodiscard]] constexpr std::optional<T> meet(const state& a, const plane<N, T>& p) const {
        const auto m = relative_motion_of(a.state, p);
        const T height = plane_height{}(m);
        const T speed = plane_speed{}(m);
        const encounter what = encounter_of([&] { return graze::sign(height) * graze::sign(speed); },
                                            [&] { return graze::sign(T(plane_clearance{}(m))); }, [] { return 1; });
        if (!is_collision(what)) {
            return std::nullopt;
        }
        if (what == encounter::overlap) {
            return a.since;
        }
        const T reach = m.r * graze::square_root(T(graze::squared_norm(m.n)));
        return T(a.since + T(plane_touch_time{}(height, speed, reach)));
    }
    // A wall or a triangle.
    template <class W>
    [[nodiscard]] constexpr std::optional<T> meet(const state& a, const W& w) const {
        const auto m = detail::flat_motion_of(a.state, w);
        const detail::direct_judge<N, T> judge(m, V);
        const flat_answer found = detail::decide_directly(m, judge);
        if (!is_collision(found.what)) {
            return std::nullopt;
        }
        if (found.what == encounter::overlap) {
            return a.since;
        }
        if (found.where == graze::feature::face) {
            return meet(a, plane_of(w));
        }
        const auto approach = judge.feature(found.where, found.index);
        return root_from(a.since, approach.q, approach.discriminant, found.what);
    }
    [[nodiscard]] constexpr wall_encounter feature(const state& a, const triangle<T>& t) const requires(N == 3) {
        const auto m = detail::flat_motion_of(a.state, t);
        const flat_answer found = detail::decide_directly(m, detail::direct_judge<N, T>(m, V));
        return {found.what, found.where, found.index};
    }

    // In a space with periods: all in T.
    constexpr std::array<std::int32_t, 3> wrap(state& a, const vec<N, T>& period) const {
        return bring_within(a.state.position, period);
    }
    [[nodiscard]] constexpr std::optional<T> meet(const state& a, const state& b,
                                                  const image_shift<N, T>& image) const {
        return meet(a, displaced(b, image.distance()));
    }
    constexpr void bounce(state& a, state& b, const image_shift<N, T>& image, const T& when) const {
        state other = displaced(b, image.distance());
        bounce(a, other, when);
        if (!immovable(b)) {
            b = displaced(other, -image.distance());
        }
    }
    // A wall or a triangle.
    template <class W>
    requires requires(const W& w) { w.edge; }
    [[nodiscard]] constexpr W displaced(W w, const image_shift<N, T>& image) const {
        w.corner = w.corner + image.distance();
        return w;
    }

    [[nodiscard]] constexpr int order(const T& s, const T& t) const { return s < t ? -1 : t < s ? 1 : 0; }
    // t itself where T is a double or less; otherwise widened by more than the rounding of a conversion to double.
    [[nodiscard]] constexpr time_bounds bounds(const T& t) const {
        const double near = as_double(t);
        if constexpr (number_traits<T>::digits > 0 && number_traits<T>::digits <= 53) {
            return {near, near};
        } else {
            const double off = (near < 0 ? -near : near) * 0x1p-50 + std::numeric_limits<double>::min();
            return {near - off, near + off};
        }
    }
    [[nodiscard]] constexpr T now(const state& a) const { return a.since; }
    [[nodiscard]] constexpr flight<N, double> about(const state& a) const {
        return {{make_vec<N>([&](int i) { return as_double(a.state.position[i]); }),
                 make_vec<N>([&](int i) { return as_double(a.state.velocity[i]); }), as_double(a.state.radius),
                 as_double(a.state.mass)},
                as_double(a.since)};
    }

    // Exact where each of the three numbers is the sum or difference of the others.
    [[nodiscard]] constexpr bool set_back(state& a, const T& by) const {
        const T since = T(a.since - by);
        if (order(T(since + by), a.since) != 0 || order(T(a.since - since), by) != 0) {
            return false;
        }
        a.since = since;
        return true;
    }

    // Directions of doubles are compared as in exact mechanics, so that both run the same code.
    [[nodiscard]] constexpr exact as_exact(const T& x) const {
        if constexpr (is_binary_input<T>) {
            return detail::is_finite_input(x) ? exact(x) : exact(0);
        } else {
            return x;
        }
    }

    [[nodiscard]] constexpr bool immovable(const state& a) const { return graze::sign(T(T(1) / a.state.mass)) == 0; }
    [[nodiscard]] constexpr bool is_point(const state& a) const { return graze::sign(a.state.radius) == 0; }

    constexpr void bounce(state& a, state& b, const T& when) const {
        const T from = later(a, b);
        const auto s = solve<V, F>(ball_at(a, from), ball_at(b, from));
        if (!is_collision(s.what)) { // multiply-adds may be fused here and not in meet
            pass(a, when);
            pass(b, when);
            return;
        }
        leave(a, s.position_a, s.velocity_a, when);
        leave(b, s.position_b, s.velocity_b, when);
    }
    template <class S>
    constexpr void bounce(state& a, const S& standing, const T& when) const {
        const auto s = solve<V, F>(a.state, standing);
        if (is_collision(s.what)) {
            leave(a, s.position, s.velocity, when);
        } else {
            pass(a, when);
        }
    }

    template <class S>
    [[nodiscard]] constexpr int side(const state& a, const S& standing) const {
        return graze::sign(T(plane_height{}(relative_motion_of(a.state, plane_of(standing)))));
    }
    template <class S>
    [[nodiscard]] constexpr int heading(const state& a, const S& standing) const {
        return graze::sign(T(plane_speed{}(relative_motion_of(a.state, plane_of(standing)))));
    }
    template <class S>
    [[nodiscard]] constexpr T reach(const state& a, const S& standing) const {
        const auto m = relative_motion_of(a.state, plane_of(standing));
        return T(a.since + T(centre_crossing_time{}(T(plane_height{}(m)), T(plane_speed{}(m)))));
    }
    template <class S>
    constexpr void turn_back(state& a, const S& standing) const {
        a.state.velocity = reflected_unnormalised(a.state.velocity, plane_of(standing).normal);
    }

    // The ball as it is at a time.
    [[nodiscard]] constexpr ball<N, T> ball_at(const state& a, const T& when) const {
        return {position_at(a.state.position, a.state.velocity, T(when - a.since)), a.state.velocity, a.state.radius,
                a.state.mass};
    }

  private:
    [[nodiscard]] static constexpr state displaced(state a, const vec<N, T>& by) {
        a.state.position = a.state.position + by;
        return a;
    }
    [[nodiscard]] static constexpr double as_double(const T& x) { return static_cast<double>(x); }
    [[nodiscard]] static constexpr T later(const state& a, const state& b) {
        return a.since < b.since ? b.since : a.since;
    }
    [[nodiscard]] static constexpr T root_from(const T& from, const quadratic<T, T, T>& q, const T& discriminant,
                                               encounter what) {
        return T(from + detail::first_root<F>(q, discriminant, what));
    }
    template <class M, class D>
    [[nodiscard]] static constexpr std::optional<T> first_time(const M& m, const T& from, D discriminant_of) {
        const quadratic<T, T, T> q = quadratic_of(m);
        T discriminant(0);
        const encounter what = encounter_of([&] { return graze::sign(q.h); }, [&] { return graze::sign(q.c); },
                                            [&] { return graze::sign(discriminant = discriminant_of(q)); });
        if (!is_collision(what)) {
            return std::nullopt;
        }
        return what == encounter::overlap ? from : root_from(from, q, discriminant, what);
    }
    [[nodiscard]] static constexpr const plane<N, T>& plane_of(const plane<N, T>& p) { return p; }
    template <class W>
    [[nodiscard]] static constexpr plane<N, T> plane_of(const W& w) {
        return {w.corner, face_normal(w.edge)};
    }
    constexpr void leave(state& a, const vec<N, T>& position, const vec<N, T>& velocity, const T& when) const {
        if (!immovable(a)) {
            a.state.position = position;
            a.state.velocity = velocity;
            a.since = when;
        }
    }
    // For a touch that rounding has undone: a flies on, with the epoch `when`.
    constexpr void pass(state& a, const T& when) const { leave(a, ball_at(a, when).position, a.state.velocity, when); }
};

} // namespace graze::inline v0_1
