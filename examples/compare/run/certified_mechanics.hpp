// What a run asks of its number type, answered with certainty or not at all.
#pragma once

#include "certified.hpp"

#include <graze/formula/root_order.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/solve.hpp>

#include <algorithm>
#include <optional>

namespace compare::run {

// When things meet. Where both were rational before, the quadratic whose smaller root it is too, in absolute time, so
// that ties are found exactly even between times that are no rationals.
struct certified_time {
    using coefficients = graze::quadratic<certified, certified, certified>;
    certified value;
    std::optional<coefficients> exactly;
};

// The sign of s - t. Throws graze::undecided.
[[nodiscard]] int order_of(const certified_time& s, const certified_time& t);

// Predictions and contacts by the formulas of `solve`, every one a proof: what is empty does not meet, what is returned
// encloses the truth. Throws graze::undecided where the intervals leave a decision open.
template <int N>
class certified_mechanics {
  public:
    static constexpr int dimension = N;
    using number = certified;
    using state = graze::flight<N, certified>;
    using time = certified_time;
    using ball = graze::ball<N, certified>;
    using plane = graze::plane<N, certified>;
    using wall = graze::wall<N, certified>;

    [[nodiscard]] state start(const ball& b) const { return {b, certified(0)}; }

    [[nodiscard]] std::optional<time> meet(const state& a, const state& b) const {
        if (rests(a) && rests(b)) { // most pairs of a lattice of mirrors
            return {};
        }
        return decided("whether they meet", a, [&]() -> std::optional<time> {
            common now(*this, a, b);
            now.a.mass = now.b.mass = 1; // masses have no part in it, and two infinite ones no common velocity
            const auto s = graze::solve(now.a, now.b);
            if (!graze::is_collision(s.what)) {
                return {};
            }
            time found{now.t + s.time, {}};
            if (is_rational(a) && is_rational(b)) {
                found.exactly = graze::quadratic_of(graze::relative_motion_of(ball_at(a, 0), ball_at(b, 0)));
            }
            return found;
        });
    }
    [[nodiscard]] std::optional<time> meet(const state& a, const plane& p) const { return meet_standing(a, p); }
    [[nodiscard]] std::optional<time> meet(const state& a, const wall& w) const { return meet_standing(a, w); }

    [[nodiscard]] int order(const time& s, const time& t) const { return order_of(s, t); }
    [[nodiscard]] int order(const time& s, const number& t) const { return order_of(s, {t, {}}); }

    void bounce(state& a, state& b, const time& t) const {
        decided("how they part", a, [&] {
            const common now(*this, a, b);
            const auto s = graze::solve(now.a, now.b);
            if (!immovable(a)) {
                a = {{s.position_a, s.velocity_a, a.state.radius, a.state.mass}, t.value};
            }
            if (!immovable(b)) {
                b = {{s.position_b, s.velocity_b, b.state.radius, b.state.mass}, t.value};
            }
        });
    }
    void bounce(state& a, const plane& p, const time& t) const { bounce_off(a, p, t); }
    void bounce(state& a, const wall& w, const time& t) const { bounce_off(a, w, t); }

    [[nodiscard]] int side(const state& a, const plane& p) const {
        return decided("on which side it is", a,
                       [&] { return graze::sign(graze::plane_height{}(graze::relative_motion_of(a.state, p))); });
    }
    [[nodiscard]] int heading(const state& a, const plane& p) const {
        return decided("whether it comes or goes", a,
                       [&] { return graze::sign(graze::plane_speed{}(graze::relative_motion_of(a.state, p))); });
    }
    void turn_back(state& a, const plane& p) const {
        a.state.velocity = graze::reflected_unnormalised(a.state.velocity, p.normal);
    }
    [[nodiscard]] int side(const state& a, const wall& w) const { return side(a, plane_of(a, w)); }
    [[nodiscard]] int heading(const state& a, const wall& w) const { return heading(a, plane_of(a, w)); }
    void turn_back(state& a, const wall& w) const { turn_back(a, plane_of(a, w)); }

    [[nodiscard]] graze::time_bounds bounds(const time& t) const { return t.value.bounds(); }
    [[nodiscard]] time now(const state& a) const { return {a.since, {}}; }
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

    // The ball as it is at a time.
    [[nodiscard]] ball ball_at(const state& a, const certified& t) const {
        ball moved = a.state;
        moved.position = graze::position_at(moved.position, moved.velocity, t - a.since);
        return moved;
    }

  private:
    // Two balls at the later of the two instants from which they fly.
    struct common {
        certified t;
        ball a, b;
        common(const certified_mechanics& m, const state& x, const state& y)
            : t(larger(x.since, y.since)), a(m.ball_at(x, t)), b(m.ball_at(y, t)) {}
    };

    static bool all_rational(const graze::vec<N, certified>& x) {
        return std::all_of(x.component, x.component + N, [](const certified& c) { return c.is_rational(); });
    }
    static bool is_rational(const state& a) {
        return a.since.is_rational() && all_rational(a.state.position) && all_rational(a.state.velocity);
    }
    static bool rests(const state& a) {
        const auto& u = a.state.velocity;
        return std::all_of(u.component, u.component + N, [](const certified& c) { return c.certain_sign() == 0; });
    }
    static plane plane_of(const state& a, const wall& w) { return {w.corner, graze::relative_motion_of(a.state, w).n}; }

    static certified_time::coefficients coefficients_of(const ball& b, const plane& p,
                                                        const graze::wall_solution<N, certified>&) {
        return graze::quadratic_of(graze::relative_motion_of(b, p));
    }
    static certified_time::coefficients coefficients_of(const ball& b, const wall& w,
                                                        const graze::wall_solution<N, certified>& s) {
        const auto m = graze::relative_motion_of(b, w);
        if (s.where == graze::feature::face) {
            return graze::quadratic_of(graze::relative_motion_of(b, plane{w.corner, m.n}));
        }
        if constexpr (N == 3) {
            if (s.where == graze::feature::edge) {
                return graze::edge_quadratic(graze::seen_from(m, graze::edge_view(s.index)));
            }
        }
        return graze::quadratic_of(graze::corner_motion(graze::seen_from(m, graze::wall_view{s.index, false})));
    }

    template <class Standing>
    std::optional<time> meet_standing(const state& a, const Standing& standing) const {
        return decided("whether they meet", a, [&]() -> std::optional<time> {
            const auto s = graze::solve(a.state, standing);
            if (!graze::is_collision(s.what)) {
                return {};
            }
            time found{a.since + s.time, {}};
            if (is_rational(a)) {
                found.exactly = coefficients_of(ball_at(a, 0), standing, s);
            }
            return found;
        });
    }
    template <class Standing>
    void bounce_off(state& a, const Standing& standing, const time& t) const {
        if (immovable(a)) { // nothing changes its flight
            return;
        }
        decided("how it bounces", a, [&] {
            const auto s = graze::solve(a.state, standing);
            a = {{s.position, s.velocity, a.state.radius, a.state.mass}, t.value};
        });
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
