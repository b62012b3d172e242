// What a run asks of its number type, answered with certainty or not at all.
#pragma once

#include "certified_flight.hpp"
#include "certified_time.hpp"
#include "flat_shape.hpp"

#include <graze/run/plain_mechanics.hpp>
#include <graze/solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace compare::run {

// Predictions and contacts by the formulas of `solve`, each of them a proof: an empty answer means that the two do not
// meet, and a time encloses the true one. Throws graze::undecided if the intervals leave a decision open that matters
// now. Whether two meet matters only when it is time.
template <int N>
class certified_mechanics {
  public:
    static constexpr int dimension = N;
    using number = certified;
    using state = certified_flight<N>;
    using time = certified_time;
    using exact = certified;
    static constexpr bool rounds = false;
    using ball = graze::ball<N, certified>;
    using plane = graze::plane<N, certified>;

    [[nodiscard]] state start(const ball& b) const { return {{b, certified(0)}}; }

    [[nodiscard]] std::optional<time> meet(const state& a, const state& b) const {
        if (rests(a) && rests(b)) { // most pairs in a lattice of mirrors
            return {};
        }
        return decided("whether they meet", a, [&]() -> std::optional<time> {
            const common now(*this, a, b);
            try {
                const std::optional<certified> when = formulas().meet({now.a, now.t}, {now.b, now.t});
                return when ? std::optional(time_of(*when, a, b)) : std::nullopt;
            } catch (const undecided_sign&) {
                if (a.line || b.line) {
                    return meet(exactly(a), exactly(b));
                }
                const auto m = graze::relative_motion_of(now.a, now.b);
                return not_before(now.t, sqrt(graze::squared_norm(m.dx)) - m.R, sqrt(graze::squared_norm(m.du)),
                                  graze::quadratic_of(m));
            }
        });
    }
    // Standing is a plane, a wall or a triangle.
    template <class Standing>
    [[nodiscard]] std::optional<time> meet(const state& a, const Standing& standing) const {
        return decided("whether they meet", a, [&]() -> std::optional<time> {
            try {
                const std::optional<certified> when = formulas().meet(a, standing);
                return when ? std::optional(time_of(*when, a, standing)) : std::nullopt;
            } catch (const undecided_sign&) {
                if (a.line) {
                    return meet(exactly(a), standing);
                }
                const auto m = graze::relative_motion_of(a.state, plane_of(standing));
                const certified height = graze::plane_height{}(m), speed = graze::plane_speed{}(m);
                return not_before(a.since, larger(height, -height) - m.r * sqrt(graze::squared_norm(m.n)),
                                  larger(speed, -speed), {});
            }
        });
    }
    // If the feature is open, so is whether they meet, and `meet` has said so.
    [[nodiscard]] graze::wall_encounter feature(const state& a, const graze::triangle<certified>& t) const
        requires(N == 3) {
        try {
            const auto met = graze::solve(exactly(a).state, t);
            return {met.what, met.where, met.index};
        } catch (const undecided_sign&) {
            return {};
        }
    }

    [[nodiscard]] int order(const time& s, const time& t) const { return order_of(s, t); }
    [[nodiscard]] int order(const time& s, const number& t) const { return order_of(s, {t, nullptr}); }

    void bounce(state& a, state& b, const time& t) const {
        decided("how they part", a, [&] {
            if (is_later(t, a) && is_later(t, b) && bounce_long(a, b)) {
                return;
            }
            const common now(*this, exactly(a), exactly(b));
            const auto s = graze::solve(now.a, now.b);
            be_certain(graze::is_collision(s.what));
            const certified when = now.t + s.time;
            if (!immovable(a)) {
                leave(a, when, s.position_a, s.velocity_a);
            }
            if (!immovable(b)) {
                leave(b, when, s.position_b, s.velocity_b);
            }
        });
    }
    template <class Standing>
    void bounce(state& a, const Standing& standing, const time& t) const {
        if (immovable(a)) { // nothing changes its flight
            return;
        }
        decided("how it bounces", a, [&] {
            if (a.line && is_later(t, a) && is_face(a, standing) && bounce_long(a, plane_of(standing))) {
                return;
            }
            const state x = exactly(a);
            const auto s = graze::solve(x.state, standing);
            be_certain(graze::is_collision(s.what));
            leave(a, x.since + s.time, s.position, s.velocity);
        });
    }

    // For scenes with a period. An image of something is the thing itself, moved by a number of periods.
    std::array<std::int32_t, 3> wrap(state& a, const graze::vec<N, certified>& period) const {
        std::array<std::int32_t, 3> gone{};
        graze::vec<N, certified> by = graze::make_vec<N>([](int) { return certified(0); });
        for (int i = 0; i < N; ++i) {
            if (period[i].certain_sign() != 0) { // any nearby whole number of periods will do
                const double periods = near_double(a.state.position[i]) / near_double(period[i]);
                if (!(periods < 0x1p30 && periods > -0x1p30)) {
                    throw std::range_error("a position is too many periods away");
                }
                gone[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(std::nearbyint(periods));
                by[i] = certified(-gone[static_cast<std::size_t>(i)]) * period[i];
            }
        }
        a = displaced(a, by);
        return gone;
    }
    [[nodiscard]] std::optional<time> meet(const state& a, const state& b,
                                           const graze::image_shift<N, certified>& image) const {
        return meet(a, displaced(b, image.distance()));
    }
    void bounce(state& a, state& b, const graze::image_shift<N, certified>& image, const time& t) const {
        const auto distance = image.distance();
        state there = displaced(b, distance);
        bounce(a, there, t);
        if (!immovable(b)) {
            b = displaced(there, -distance);
        }
    }
    template <flat_shape W>
    [[nodiscard]] W displaced(W w, const graze::image_shift<N, certified>& image) const {
        w.corner = w.corner + image.distance();
        return w;
    }

    template <class Standing>
    [[nodiscard]] int side(const state& a, const Standing& standing) const {
        return decided("on which side it is", a, [&] {
            const auto m = graze::relative_motion_of(exactly(a).state, plane_of(standing));
            return graze::sign(graze::plane_height{}(m));
        });
    }
    template <class Standing>
    [[nodiscard]] int heading(const state& a, const Standing& standing) const {
        return decided("whether it comes or goes", a, [&] {
            const auto m = graze::relative_motion_of(exactly(a).state, plane_of(standing));
            return graze::sign(graze::plane_speed{}(m));
        });
    }
    template <class Standing>
    [[nodiscard]] time reach(const state& a, const Standing& standing) const {
        return decided("when it is there", a, [&] {
            const auto m = graze::relative_motion_of(exactly(a).state, plane_of(standing));
            return time{a.since + graze::centre_crossing_time{}(graze::plane_height{}(m), graze::plane_speed{}(m)),
                        nullptr};
        });
    }
    template <class Standing>
    void turn_back(state& a, const Standing& standing) const {
        a = exactly(a);
        a.state.velocity = graze::reflected_unnormalised(a.state.velocity, plane_of(standing).normal);
    }

    [[nodiscard]] graze::time_bounds bounds(const time& t) const { return t.value.bounds(); }
    [[nodiscard]] certified as_exact(const certified& x) const { return x; }
    [[nodiscard]] time now(const state& a) const { return {a.since, nullptr}; }
    [[nodiscard]] bool immovable(const state& a) const { return a.state.mass.is_infinite(); }
    [[nodiscard]] bool is_point(const state& a) const { return a.state.radius.sign() == 0; }
    [[nodiscard]] graze::flight<N, double> about(const state& a) const {
        const auto near = [](const graze::vec<N, certified>& x) {
            return graze::make_vec<N>([&](int i) { return near_double(x[i]); });
        };
        return {
            {near(a.state.position), near(a.state.velocity), near_double(a.state.radius), near_double(a.state.mass)},
            near_double(a.since)};
    }

    // The ball as it is at time t.
    [[nodiscard]] ball ball_at(const state& a, const certified& t) const {
        ball moved = a.state;
        moved.position = graze::position_at(moved.position, moved.velocity, t - a.since);
        return moved;
    }

  private:
    using formulas = graze::plain_mechanics<N, certified, graze::variant::lagrange>;

    // Two balls at the later of their two epochs.
    struct common {
        certified t;
        ball a, b;
        common(const certified_mechanics& m, const state& x, const state& y)
            : t(larger(x.since, y.since)), a(m.ball_at(x, t)), b(m.ball_at(y, t)) {}
    };

    // a moved by a distance. If that is 0, a itself, not a copy computed anew.
    [[nodiscard]] static state displaced(const state& a, const graze::vec<N, certified>& by) {
        if (std::all_of(by.component, by.component + N, [](const certified& c) { return c.certain_sign() == 0; })) {
            return a;
        }
        state moved = exactly(a);
        moved.state.position = moved.state.position + by;
        shorten(moved);
        return moved;
    }
    static bool rests(const state& a) {
        const auto& u = a.state.velocity;
        return std::all_of(u.component, u.component + N, [](const certified& c) { return c.certain_sign() == 0; });
    }
    static const plane& plane_of(const plane& p) { return p; }
    template <flat_shape W>
    static plane plane_of(const W& w) {
        return {w.corner, graze::face_normal(w.edge)};
    }

    static certified_time::coefficients coefficients_of(const ball& b, const plane& p,
                                                        const graze::wall_solution<N, certified>&) {
        return graze::quadratic_of(graze::relative_motion_of(b, p));
    }
    template <flat_shape W>
    static certified_time::coefficients coefficients_of(const ball& b, const W& w,
                                                        const graze::wall_solution<N, certified>& s) {
        const auto m = graze::relative_motion_of(b, w);
        if (s.where == graze::feature::face) {
            return graze::quadratic_of(graze::face_of(m));
        }
        if constexpr (N == 3) {
            if (s.where == graze::feature::edge) {
                const int edge = graze::edge_number(s.index, is_triangle<W>);
                return graze::edge_quadratic(graze::seen_from(m, graze::edge_view(edge)));
            }
        }
        return graze::quadratic_of(graze::corner_motion(graze::seen_from(m, graze::wall_view{s.index, false})));
    }

    // The time, with its quadratic if the time is not exact but the flights are.
    template <class Other>
    [[nodiscard]] time time_of(const certified& when, const state& a, const Other& other) const {
        time found{when, {}};
        if constexpr (std::is_same_v<Other, state>) {
            if (!when.is_exact() && is_exact(a) && is_exact(other)) {
                found.exactly = [m = *this, a, other] {
                    return graze::quadratic_of(
                        graze::relative_motion_of(m.ball_at(exactly(a), 0), m.ball_at(exactly(other), 0)));
                };
            }
        } else if (!when.is_exact() && is_exact(a)) {
            found.exactly = [m = *this, a, other] {
                const state x = exactly(a);
                return coefficients_of(m.ball_at(x, 0), other, graze::solve(x.state, other));
            };
        }
        return found;
    }
    // Whether a contact at t is a touch, rather than an overlap since the start of the flight.
    [[nodiscard]] static bool is_later(const time& t, const state& a) {
        return (t.value - a.since).certain_sign() == 1;
    }
    void leave(state& a, const certified& when, const graze::vec<N, certified>& position,
               const graze::vec<N, certified>& velocity) const {
        a = {{{position, velocity, a.state.radius, a.state.mass}, when}};
        shorten(a);
    }

    // Whether what a meets is certainly the face.
    static bool is_face(const state&, const plane&) { return true; }
    template <flat_shape W>
    static bool is_face(const state& a, const W& w) {
        try {
            return graze::solve(a.state, w).where == graze::feature::face;
        } catch (const undecided_sign&) {
            return false;
        }
    }

    static void be_certain(bool they_meet) {
        if (!they_meet) { // `meet` left it open whether they meet
            throw undecided_sign();
        }
    }
    template <class Answer>
    static auto decided(const char* comparison, const state& a, Answer answer) {
        try {
            return answer();
        } catch (const undecided_sign&) {
            throw graze::undecided(comparison, near_double(a.since));
        }
    }
};

} // namespace compare::run
