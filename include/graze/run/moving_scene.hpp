// The parts of a scene while a run changes them, and the questions about them.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/point/points.hpp>
#include <graze/point/standing_images.hpp>
#include <graze/run/grazed_balls.hpp>
#include <graze/run/image_ledger.hpp>
#include <graze/run/scene_parts.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/saying.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace graze::inline v0_1::detail {

// The parts, and what they have met so far.
template <mechanics M>
class moving_scene : public scene_parts<M> {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;
    using time = typename M::time;
    using scene_parts<M>::rules;
    using scene_parts<M>::is_periodic;
    using scene_parts<M>::has_images;
    using scene_parts<M>::balls;
    using scene_parts<M>::bodies;
    using scene_parts<M>::named;

    moving_scene(const scene<dimension, number>& s, M m)
        : scene_parts<M>(s, std::move(m)), counts_(s.balls.size()), ledger_(is_periodic() ? s.balls.size() : 0),
          points_(balls_.has_points() && bodies() > balls() ? balls() : 0) {}

    // The number of a ball's events; a prediction made with another count is stale. An immovable ball's count never
    // changes.
    [[nodiscard]] std::uint32_t count(body a) const noexcept { return counts_[a]; }
    // In a scene that has a period: how many periods ball a has gone back.
    [[nodiscard]] image_index gone(body a) const noexcept { return ledger_.gone(a); }
    // Fetches a ball from memory.
    void fetch(body a) const noexcept {
        detail::fetch(balls_.movers[a]);
        detail::fetch(counts_[a]);
    }

    // False if the two balls have not just met, for a ball that can turn by its own record: b's may be far away in
    // memory.
    [[nodiscard, gnu::always_inline]] bool may_have_just_met(body a, body b) const noexcept {
        return balls_.movers[a].last == b || (balls_.movers[a].immovable && balls_.movers[b].last == a);
    }
    // Whether the two have just met: neither has had another event since, and both fly straight, so they part. Events
    // change nothing for an immovable ball; it meets each plane or wall once.
    [[nodiscard, gnu::always_inline]] bool have_just_met(body a, body b, image_index image = {}) const noexcept {
        if (b < balls() && balls_.movers[a].last != b && balls_.movers[b].last != a) [[likely]] {
            return false;
        }
        if (b >= balls() && balls_.movers[a].immovable) {
            return std::find(passed_.begin(), passed_.end(), passage{a, b, image}) != passed_.end();
        }
        if (is_periodic() && has_images(b) &&
            !(balls_.movers[a].last == b ? ledger_.last(a) == image
                                         : b < balls() && ledger_.last(b) == image_index{} - image)) {
            return false;
        }
        const auto turned = [&](body x, body y) { return !balls_.movers[x].immovable && balls_.movers[x].last != y; };
        return b < balls() ? !turned(a, b) && !turned(b, a) : balls_.movers[a].last == b;
    }

    // When a and that image of b meet, a < b; empty if they don't.
    [[nodiscard]] std::optional<time> meet(body a, body b, image_index image = {}) const {
        return saying_who(a, b, [&] {
            const state& x = balls_.movers[a].state;
            return b < balls()     ? images_.meet(x, balls_.movers[b].state, ledger_.periods(a, b, image))
                   : is_watched(a) ? meet_as_point(a, {b, image})
                                   : standing_.meet(images_, x, b, ledger_.periods(a, b, image));
        });
    }

    // Bounds on when a and b meet, a < b; from the largest double on if they don't, or if the mechanics says that it is
    // certainly later than `latest`.
    [[nodiscard, gnu::always_inline]] time_bounds meet_until(body a, body b, image_index image, double latest) const {
        return b < balls() ? meet_across(a, b, ledger_.periods(a, b, image), latest) : meet_standing(a, b, image);
    }
    // The same for two balls and the image that is some periods from b, as the two fly.
    [[nodiscard, gnu::always_inline]] time_bounds meet_across(body a, body b, image_index periods,
                                                              double latest) const {
        return images_.meet_until(balls_.movers[a].state, balls_.movers[b].state, periods, latest);
    }
    // Which plane or wall a point meets first of those that it meets at exactly this time; none for a ball.
    [[nodiscard]] standing_image first_standing(body a, const time& when) const {
        return is_watched(a) ? points_[a].first_at(seen_by(a, &when), balls_.movers[a].state) : standing_image{};
    }

    // Gives a, and b if it is a ball, the state after they have met. alone: neither meets anything else at that time.
    void bounce(body a, body b, image_index image, const time& when, bool alone) {
        saying_who(a, b, [&] { change(a, b, image, when, alone); });
    }

    // Ball a stays where its last event was and no longer meets `presser`.
    void stop(body a, body presser) {
        mover<state>& x = balls_.movers[a];
        x.state.state.velocity = make_vec<dimension>([](int) { return number(0); });
        x.last = presser;
        ledger_.meet(a, {});
        x.stopped = true;
        ++counts_[a];
    }
    using point = point_among<dimension, state, typename M::exact>;
    using memory = ball_memory<state, point>;
    [[nodiscard]] memory remember(body a) const {
        return {balls_.movers[a], counts_[a], is_watched(a) ? std::optional(points_[a]) : std::nullopt, passed_.size(),
                ledger_.get(a)};
    }
    void restore(body a, memory& m) noexcept {
        balls_.movers[a] = std::move(m.ball);
        counts_[a] = m.count;
        passed_.resize(m.passed);
        ledger_.set(a, m.image);
        if (m.among) {
            points_[a] = std::move(*m.among);
        }
    }

    // Puts ball a back on its flight, and only that.
    void take_back(body a, const memory& m) {
        balls_.movers[a].state = m.ball.state;
        ledger_.set(a, m.image);
    }

    // Gives ball a another state. A point that is still on its way, but for rounding, keeps the sides on which it
    // belongs; elsewhere they would mean nothing.
    void restate(body a, state other) {
        const flight<dimension, double> f = rules().about(balls_.movers[a].state), g = rules().about(other);
        if (is_watched(a)) {
            points_[a].restate(seen_by(a), balls_.movers[a].state, is_on_the_way(f, g), ledger_.gone(a));
        }
        balls_.movers[a].stopped = false;
        const bool flies_on = balls_.movers[a].immovable && is_same_flight(f, g);
        balls_.movers[a].state = std::move(other);
        balls_.movers[a].last = flies_on ? balls_.movers[a].last : no_body;
        if (!flies_on) {
            ledger_.set(a, {});
            bring_back(a);
            passed_.erase(std::remove_if(passed_.begin(), passed_.end(), [&](const passage& p) { return p.a == a; }),
                          passed_.end());
        }
    }

  private:
    using scene_parts<M>::images_;
    using scene_parts<M>::standing_;
    using scene_parts<M>::balls_;

    [[nodiscard]] time_bounds meet_standing(body a, body b, image_index image) const {
        const std::optional<time> when = meet(a, b, image);
        constexpr double never = std::numeric_limits<double>::max();
        return when ? rules().bounds(*when) : time_bounds{never, never};
    }
    template <class F>
    auto saying_who(body a, body b, F f) const {
        return saying(f, [&] { return named(a, b); });
    }
    [[nodiscard]] standing_images<M> seen_by(body a, const time* when = nullptr) const {
        return {standing_, images_, ledger_.gone(a), when};
    }
    [[nodiscard]] std::optional<time> meet_as_point(body a, const standing_image& b) const {
        const point& p = points_[a];
        const state& x = balls_.movers[a].state;
        const standing_images<M> seen = seen_by(a);
        const auto next = p.meet(seen, x, b);
        std::optional<time> when;
        if (next != point::next::never) {
            when = next == point::next::now ? std::optional<time>(rules().now(x)) : seen.time_of(b, x);
        }
        if (when && p.may_be_hidden(b) && p.is_hidden(seen_by(a, &*when), x, b)) {
            when.reset();
        }
        return when;
    }
    // Whether a is a point and there are planes or walls that it may meet.
    [[nodiscard]] bool is_watched(body a) const noexcept { return !points_.empty() && balls_.movers[a].point; }

    void bring_back(body a) {
        if (is_periodic() && !balls_.movers[a].immovable) {
            if (const image_index periods = images_.bring_back(balls_.movers[a].state); periods != image_index{}) {
                ledger_.bring_back(a, periods);
            }
        }
    }

    void change(body a, body b, image_index image, const time& when, bool alone) {
        mover<state>& x = balls_.movers[a];
        if (b < balls()) {
            mover<state>& y = balls_.movers[b];
            const std::optional<state> before_a = before_ball(a);
            const std::optional<state> before_b = before_ball(b);
            images_.bounce(x.state, y.state, ledger_.periods(a, b, image), when);
            note(a, before_a, when, alone);
            note(b, before_b, when, alone);
            y.last = a;
            ledger_.meet(b, image_index{} - image);
            bring_back(b);
            counts_[b] += y.immovable ? 0 : 1;
        } else if (is_watched(a)) {
            points_[a].bounce(seen_by(a, &when), x.state, {b, image}, alone);
        } else {
            if (x.immovable) {
                passed_.push_back({a, b, image});
            }
            seen_by(a, &when).bounce({b, image}, x.state);
        }
        x.last = b;
        ledger_.meet(a, image);
        bring_back(a);
        counts_[a] += x.immovable ? 0 : 1;
    }
    [[nodiscard]] std::optional<state> before_ball(body a) const {
        return is_watched(a) ? std::optional<state>(balls_.movers[a].state) : std::nullopt;
    }
    void note(body a, const std::optional<state>& before, const time& when, bool alone) {
        if (before) {
            points_[a].meet_ball(seen_by(a, &when), *before, balls_.movers[a].state,
                                 {balls_.movers[a].last, ledger_.last(a)}, alone);
        }
    }

    records<std::uint32_t> counts_; // side by side, since they are read far more often than flights
    image_ledger ledger_;
    records<passage> passed_; // immovable balls, and the planes and walls that they have met
    records<point> points_;   // if there are any, and planes or walls that they can meet
};

} // namespace graze::inline v0_1::detail
