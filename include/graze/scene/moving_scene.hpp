// The parts of a scene while a run changes them, and the questions about them.
#pragma once

#include <graze/scene/canonical_order.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/scene/mover.hpp>
#include <graze/scene/points.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace graze::inline v0_1::detail {

// Balls, planes, walls and triangles in their canonical order, by which everything here is numbered, so that nothing
// depends on the order in which the scene lists them.
template <mechanics M>
class moving_scene {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;
    using time = typename M::time;

    moving_scene(const scene<dimension, number>& s, M m)
        : mechanics_(std::move(m)), standing_((check(s), s), static_cast<body>(s.balls.size())),
          ball_names_(canonical_order(s.balls)), counts_(s.balls.size()) {
        movers_.reserve(ball_names_.size());
        bool points = false;
        for (const int i : ball_names_) {
            mover<state> b{mechanics_.start(s.balls[static_cast<std::size_t>(i)])};
            b.immovable = mechanics_.immovable(b.state);
            b.point = !b.immovable && mechanics_.is_point(b.state);
            points = points || b.point;
            movers_.push_back(std::move(b));
        }
        points_.resize(points && bodies() > balls() ? movers_.size() : 0);
    }

    [[nodiscard]] const M& rules() const noexcept { return mechanics_; }
    [[nodiscard]] body balls() const noexcept { return static_cast<body>(movers_.size()); }
    [[nodiscard]] body bodies() const noexcept { return standing_.end(); }
    [[nodiscard]] mover<state>& operator[](body a) noexcept { return movers_[a]; }
    [[nodiscard]] const mover<state>& operator[](body a) const noexcept { return movers_[a]; }
    // Asks for a ball that will soon be looked at, without waiting for it.
    void fetch(body a) const noexcept {
        __builtin_prefetch(&movers_[a]);
        __builtin_prefetch(&movers_[a].last); // at the other end
    }
    // Of a ball's events; what was foreseen with another count is no longer true. An immovable ball's flight never
    // changes, nor does its count.
    [[nodiscard]] std::uint32_t count(body a) const noexcept { return counts_[a]; }
    [[nodiscard]] int name(body a) const noexcept { return ball_names_[a]; }

    // By the scene's own indices; of two balls the one first that comes first by its numbers.
    [[nodiscard]] meeting named(body a, body b) const noexcept {
        return b < balls() ? meeting{partner::ball, name(a), name(b)} : standing_.named(name(a), b);
    }

    [[nodiscard]] bool is_stale(const foreseen& f) const noexcept {
        return counts_[f.a] != f.count_a || (f.b < balls() && counts_[f.b] != f.count_b);
    }

    // Whether the two have just met: neither has had another event since, and both fly straight, so that they part.
    // What meets an immovable ball changes nothing for that ball; it meets what stands once.
    [[nodiscard]] bool have_just_met(body a, body b) const noexcept {
        if (b >= balls() && movers_[a].immovable) {
            return std::find(passed_.begin(), passed_.end(), std::pair(a, b)) != passed_.end();
        }
        const auto turned = [&](body x, body y) { return !movers_[x].immovable && movers_[x].last != y; };
        return b < balls() ? (movers_[a].last == b || movers_[b].last == a) && !turned(a, b) && !turned(b, a)
                           : movers_[a].last == b;
    }

    // When a and b meet, a < b; empty if they don't.
    [[nodiscard]] std::optional<time> meet(body a, body b) const {
        try {
            if (b < balls()) {
                return mechanics_.meet(movers_[a].state, movers_[b].state);
            }
            if (is_watched(a)) {
                return points_[a].meet(mechanics_, standing_, movers_[a].state, b);
            }
            return standing_.meet(mechanics_, movers_[a].state, b);
        } catch (graze::undecided& e) {
            e.between(named(a, b));
            throw;
        } catch (const std::domain_error& e) { // parallel edges, or what restate was given
            throw std::domain_error(to_string(named(a, b)) + ": " + e.what());
        }
    }

    // Around when a and b meet, a < b; from the largest double on if they don't, or if that is certainly later than
    // `latest` and the mechanics says so.
    [[nodiscard, gnu::always_inline]] time_bounds meet_until(body a, body b, double latest) const {
        if constexpr (requires { mechanics_.meet_until(movers_[a].state, movers_[b].state, latest); }) {
            if (b < balls()) {
                return mechanics_.meet_until(movers_[a].state, movers_[b].state, latest);
            }
        }
        const std::optional<time> when = meet(a, b);
        constexpr double never = std::numeric_limits<double>::max();
        return when ? mechanics_.bounds(*when) : time_bounds{never, never};
    }
    // Where planes and walls are.
    [[nodiscard]] std::vector<standing_extent<dimension>> extents() const { return standing_.extents(mechanics_); }

    // Which plane or wall a point meets first of those that it meets at exactly this time; no_body for a ball.
    [[nodiscard]] body first_standing(body a, const time& when) const {
        return is_watched(a) ? points_[a].first_at(mechanics_, standing_, movers_[a].state, when) : no_body;
    }

    // Ball a's state, and b's if it is a ball, after they have met; alone: neither meets anything else at that time.
    void bounce(body a, body b, const time& when, bool alone) {
        try {
            change(a, b, when, alone);
        } catch (graze::undecided& e) {
            e.between(named(a, b));
            throw;
        } catch (const std::overflow_error& e) {
            throw std::overflow_error(to_string(named(a, b)) + ": " + e.what());
        }
    }

    // Ball a stays where its last event was; it does not meet `presser` any more.
    void stop(body a, body presser) {
        mover<state>& x = movers_[a];
        x.state.state.velocity = make_vec<dimension>([](int) { return number(0); });
        x.last = presser;
        x.stopped = true;
        ++counts_[a];
    }
    [[nodiscard]] participant part(body b) const noexcept {
        if (b < balls()) {
            return {partner::ball, name(b)};
        }
        const meeting m = standing_.named(0, b);
        return {m.with, m.b};
    }

    // What bounce changes of a ball, to put it back.
    struct memory {
        mover<state> ball;
        std::uint32_t count;
        std::optional<point_among<M>> point;
        std::size_t passed;
    };
    [[nodiscard]] memory remember(body a) const {
        return {movers_[a], counts_[a], is_watched(a) ? std::optional(points_[a]) : std::nullopt, passed_.size()};
    }
    void restore(body a, memory& m) noexcept {
        movers_[a] = std::move(m.ball);
        counts_[a] = m.count;
        passed_.resize(m.passed);
        if (m.point) {
            points_[a] = std::move(*m.point);
        }
    }

    // Gives ball a another state. A point that is still on its way, but for rounding, keeps the sides on which it
    // belongs; elsewhere they would mean nothing.
    void restate(body a, state other) {
        const flight<dimension, double> f = mechanics_.about(movers_[a].state), g = mechanics_.about(other);
        if (is_watched(a)) {
            points_[a].restate(mechanics_, movers_[a].state, is_on_the_way(f, g));
        }
        movers_[a].stopped = false;
        const bool flies_on = movers_[a].immovable && is_same_flight(f, g);
        movers_[a].state = std::move(other);
        movers_[a].last = flies_on ? movers_[a].last : no_body;
        if (!flies_on) {
            std::erase_if(passed_, [&](const auto& p) { return p.first == a; });
        }
    }

  private:
    // Whether a is a point that something standing may meet.
    [[nodiscard]] bool is_watched(body a) const noexcept { return !points_.empty() && movers_[a].point; }

    void change(body a, body b, const time& when, bool alone) {
        mover<state>& x = movers_[a];
        if (b < balls()) {
            mover<state>& y = movers_[b];
            const std::optional<state> before_a = before_ball(a);
            const std::optional<state> before_b = before_ball(b);
            mechanics_.bounce(x.state, y.state, when);
            note(a, before_a, when, alone);
            note(b, before_b, when, alone);
            y.last = a;
            counts_[b] += y.immovable ? 0 : 1;
        } else if (is_watched(a)) {
            points_[a].bounce(mechanics_, standing_, x.state, b, when, alone);
        } else {
            standing_.with(b, [&](const auto& s) { mechanics_.bounce(x.state, s, when); });
            if (x.immovable) {
                passed_.emplace_back(a, b);
            }
        }
        x.last = b;
        counts_[a] += x.immovable ? 0 : 1;
    }
    [[nodiscard]] std::optional<state> before_ball(body a) const {
        return is_watched(a) ? std::optional<state>(movers_[a].state) : std::nullopt;
    }
    void note(body a, const std::optional<state>& before, const time& when, bool alone) {
        if (before) {
            points_[a].meet_ball(mechanics_, standing_, *before, movers_[a].state, movers_[a].last, when, alone);
        }
    }

    M mechanics_;
    standing_parts<M> standing_;
    std::vector<int> ball_names_;
    std::vector<mover<state>> movers_;
    std::vector<std::uint32_t> counts_;         // beside one another, for they are asked of far more than flights are
    std::vector<std::pair<body, body>> passed_; // immovable balls, and what stands that they have met
    std::vector<point_among<M>> points_;        // if there are any and something that they can meet
};

} // namespace graze::inline v0_1::detail
