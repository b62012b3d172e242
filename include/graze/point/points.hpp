// Balls of radius 0 among planes and walls: what they meet at an instant, and on which sides they stay.
#pragma once

#include <graze/point/arrival.hpp>
#include <graze/point/junction.hpp>
#include <graze/point/kept_sides.hpp>
#include <graze/point/lost_sides.hpp>
#include <graze/point/standing.hpp>

#include <optional>

namespace graze::inline v0_1::detail {

// What a run knows of one point beside its state.
//
// Two things can bring a point to several planes and walls at once. These may really meet at one place: then the point
// meets all of them at exactly the same time, and a junction decides what happens, by the exact directions. Or rounding
// may carry the point beyond a wall that it had not reached, or had just left: then its side of that wall is kept until
// it is there, and if it heads for the other side, it is turned back. A point that slides keeps the side on which it
// began to, of what it slides along and of what is in the same plane.
template <mechanics M>
class point_among {
  public:
    using state = typename M::state;
    using time = typename M::time;
    using parts = standing_parts<M>;
    using junction_here = junction<M::dimension, typename M::exact>;

    // When the point meets b, which it has not just met.
    [[nodiscard]] std::optional<time> meet(const M& m, const parts& standing, const state& x,
                                           const standing_image& b) const {
        std::optional<time> when = meet_whatever_side(m, standing, x, b);
        const bool is_now = here_ && here_->has(b);
        if (when && keeps_aside_ && !is_now && arrival_at(m, standing, x, *when).is_beyond_reach(b, velocity(m, x))) {
            when.reset();
        }
        return when;
    }

    // Which of the planes and walls that it meets at exactly this time is the first.
    [[nodiscard]] standing_image first_at(const M& m, const parts& standing, const state& x, const time& when) const {
        if (here_ && here_->next().is_any()) {
            return here_->next();
        }
        auto met = arrival_at(m, standing, x, when);
        met.head(velocity(m, x));
        return met.next();
    }

    // It meets b at that time. alone: it meets nothing else then.
    void bounce(const M& m, const parts& standing, state& x, const standing_image& b, const time& when, bool alone) {
        const state before = x;
        if (here_ && here_->next() == b) {
            standing.turn_back(m, b, x);
            here_->meet(b, velocity(m, before), velocity(m, x));
        } else {
            leave_junction(m, x);
            const int heading = standing.heading(m, b, x);
            const int side = kept_.of(b);
            if (side != 0 && heading != 0 && is_beyond(m, standing, b, x, side)) {
                standing.turn_back(m, b, x);
                settle_at_border(m, standing, before, x, b, side);
            } else {
                const int from = heading != 0 ? -heading : side_along(m, standing, x, b);
                arrive(m, standing, x, b, when, alone);
                keep_sides(m, standing, before, x, when, b);
                kept_.keep(b, from);
                settle_at_border(m, standing, before, x, b, -heading);
            }
        }
        note_sliding(m, standing, x);
    }

    // It has met a ball at that time and is now x. last: what it met before. alone: it meets nothing else then.
    void meet_ball(const M& m, const parts& standing, const state& before, const state& x, const standing_image& last,
                   const time& when, bool alone) {
        const bool was_there = (here_ || is_standing(standing, last)) && m.order(when, m.now(before)) == 0;
        if (was_there) { // between two bounces
            if (!here_) {
                typename junction_here::cone_list one;
                one.push_back(standing.cone_at(m, last, kept_.of(last), approach::across, std::nullopt));
                here_.emplace(std::move(one), -velocity(m, before));
            }
            here_->leave_none();
            here_->head(velocity(m, x));
        } else {
            leave_junction(m, before);
            if (!alone) {
                if (auto met = arrival_at(m, standing, before, when); met.size() > 0) {
                    here_ = std::move(met);
                    here_->head(velocity(m, x));
                }
            }
            keep_sides(m, standing, before, x, when, {});
        }
        note_sliding(m, standing, x);
    }

    // It has been given another state. on_the_way: that state is still on its way. From then on, images are counted
    // from that one.
    void restate(const M& m, const state& x, bool on_the_way, image_index first) {
        leave_junction(m, x);
        kept_.count_from(first);
        if (!on_the_way) {
            kept_.clear();
            keeps_aside_ = false;
        }
    }

  private:
    [[nodiscard]] static vec<M::dimension, typename M::exact> velocity(const M& m, const state& x) {
        return parts::exactly(m, x.state.velocity);
    }
    [[nodiscard]] static bool is_standing(const parts& standing, const standing_image& b) noexcept {
        return b.is_any() && b.what >= standing.begin();
    }

    // meet as if no plane or wall were between it and b.
    [[nodiscard]] std::optional<time> meet_whatever_side(const M& m, const parts& standing, const state& x,
                                                         const standing_image& b) const {
        if (here_ && here_->has(b)) {
            return here_->next() == b ? std::optional<time>(m.now(x)) : std::nullopt;
        }
        if (const int side = kept_.of(b); side != 0 && is_beyond(m, standing, b, x, side)) {
            if (const int heading = standing.heading(m, b, x); heading != 0) {
                return heading * side < 0 ? std::optional<time>(m.now(x)) : std::nullopt;
            }
        }
        return standing.meet(m, b, x);
    }
    [[nodiscard]] junction_here arrival_at(const M& m, const parts& standing, const state& x, const time& when) const {
        return arrival(
            m, standing, x, when, [&](const standing_image& b) { return meet_whatever_side(m, standing, x, b); },
            [&](const standing_image& b) { return side_along(m, standing, x, b); });
    }
    void arrive(const M& m, const parts& standing, state& x, const standing_image& b, const time& when, bool alone) {
        const auto before = velocity(m, x);
        auto met = alone && !slides(m, standing, x) ? std::nullopt : std::optional(arrival_at(m, standing, x, when));
        standing.bounce(m, b, x, when);
        if (met && met->size() > 1) {
            here_ = std::move(met);
            here_->meet(b, before, velocity(m, x));
        }
    }

    // f(b, side) for all planes and walls of which the point, now x, keeps a side.
    template <class F>
    void for_each_side(const M& m, const state& x, F f) const {
        kept_.for_each([&](const standing_image& b, int side) {
            if (!here_ || !here_->has(b)) {
                f(b, side);
            }
        });
        if (here_) {
            here_->leave(velocity(m, x), f);
        }
    }
    // The side of b, in whose plane x moves: its side of any plane or wall in this plane.
    [[nodiscard]] int side_along(const M& m, const parts& standing, const state& x, const standing_image& b) const {
        int result = 0;
        for_each_side(m, x, [&](const standing_image& c, int side) {
            result = result != 0 ? result : side * (c == b ? 1 : standing.common_sense(m, c, b));
        });
        return result;
    }
    void note_sliding(const M& m, const parts& standing, const state& x) {
        keeps_aside_ = false;
        for_each_side(
            m, x, [&](const standing_image& b, int) { keeps_aside_ = keeps_aside_ || standing.heading(m, b, x) == 0; });
    }

    void settle_at_border(const M& m, const parts& standing, const state& before, const state& x,
                          const standing_image& b, int side) {
        if constexpr (M::rounds) {
            if (here_ || side == 0 || standing.side(m, b, x) * side >= 0) {
                return;
            }
            here_ = arrival_at_border(m, standing, before, x, b,
                                      [&](const standing_image& c) { return side_along(m, standing, before, c); });
            if (here_) {
                here_->meet(b, velocity(m, before), velocity(m, x));
            }
        }
    }
    void leave_junction(const M& m, const state& x) {
        if (here_) {
            here_->leave(velocity(m, x), [&](const standing_image& b, int side) { kept_.keep(b, side); });
            here_.reset();
        }
    }

    // For a point that was at `before` and has become x at that time: keeps the sides from which the rounding of its
    // position has carried it, and those on which it goes on sliding; forgets those on which it is.
    void keep_sides(const M& m, const parts& standing, const state& before, const state& x, const time& when,
                    const standing_image& met) {
        const auto is_elsewhere = [&](const standing_image& b) { return b != met && !(here_ && here_->has(b)); };
        if constexpr (M::rounds) {
            kept_sides kept;
            standing.for_each_near(m, standing.around(m, x), [&](const standing_image& b) {
                const int side = kept_.of(b);
                kept.keep(b, is_elsewhere(b) ? side_lost(m, standing, before, x, when, met, b, side) : side);
            });
            kept_ = std::move(kept);
        } else {
            kept_.keep_if([&](const standing_image& b, int side) {
                return !is_elsewhere(b) || side_lost(m, standing, before, x, when, met, b, side) != 0;
            });
        }
    }

    kept_sides kept_;
    std::optional<junction_here> here_;
    bool keeps_aside_ = false; // whether it slides on a known side of a plane or wall
};

} // namespace graze::inline v0_1::detail
