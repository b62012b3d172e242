// Balls of radius 0 among planes and walls: what they meet at an instant, and on which sides they stay.
#pragma once

#include <graze/point/arrival.hpp>
#include <graze/point/junction.hpp>
#include <graze/point/kept_sides.hpp>
#include <graze/point/lost_sides.hpp>
#include <graze/point/standing.hpp>

#include <cstdint>
#include <optional>
#include <utility>

namespace graze::inline v0_1::detail {

// What a run knows of one point beside its state.
//
// Two things can bring a point to several planes and walls at once. These may really meet at one place: then the point
// meets all of them at exactly the same time, and a junction decides what happens, by the exact directions. Or rounding
// may carry the point beyond a wall that it had not reached, or had just left: then its side of that wall is kept until
// it is there, and if it heads for the other side, it is turned back. A point that slides keeps the side on which it
// began to, of what it slides along and of what is in the same plane.
template <int N, class State, class X>
class point_among {
  public:
    using state = State;
    using parts = standing_parts<N, State, X>;
    using junction_here = junction<N, X>;

    // When the point meets b, which it has not just met, but for what stands between them: not at all, now, or when the
    // mechanics says.
    enum class next : std::uint8_t { never, now, as_told };
    [[nodiscard]] next meet(const parts& standing, const state& x, const standing_image& b) const {
        if (here_ && here_->has(b)) {
            return here_->next() == b ? next::now : next::never;
        }
        if (const int side = kept_.of(b); side != 0 && is_beyond(standing, b, x, side)) {
            if (const int heading = standing.heading(b, x); heading != 0) {
                return heading * side < 0 ? next::now : next::never;
            }
        }
        return next::as_told;
    }
    // Whether something may stand between it and b, and whether something does that it meets at that instant.
    [[nodiscard]] bool may_be_hidden(const standing_image& b) const noexcept {
        return keeps_aside_ && !(here_ && here_->has(b));
    }
    [[nodiscard]] bool is_hidden(const parts& standing, const state& x, const standing_image& b) const {
        return arrival_at(standing, x).is_beyond_reach(b, velocity(standing, x));
    }

    // Which of the planes and walls that it meets at exactly this time is the first.
    [[nodiscard]] standing_image first_at(const parts& standing, const state& x) const {
        if (here_ && here_->next().is_any()) {
            return here_->next();
        }
        auto met = arrival_at(standing, x);
        met.head(velocity(standing, x));
        return met.next();
    }

    // It meets b at that time. alone: it meets nothing else then.
    void bounce(const parts& standing, state& x, const standing_image& b, bool alone) {
        const state before = x;
        if (here_ && here_->next() == b) {
            standing.turn_back(b, x);
            here_->meet(b, velocity(standing, before), velocity(standing, x));
        } else {
            leave_junction(standing, x);
            const int heading = standing.heading(b, x);
            const int side = kept_.of(b);
            if (side != 0 && heading != 0 && is_beyond(standing, b, x, side)) {
                standing.turn_back(b, x);
                settle_at_border(standing, before, x, b, side);
            } else {
                const int from = heading != 0 ? -heading : side_along(standing, x, b);
                arrive(standing, x, b, alone);
                keep_sides(standing, before, x, b);
                kept_.keep(b, from);
                settle_at_border(standing, before, x, b, -heading);
            }
        }
        note_sliding(standing, x);
    }

    // It has met a ball at that time and is now x. last: what it met before. alone: it meets nothing else then.
    void meet_ball(const parts& standing, const state& before, const state& x, const standing_image& last, bool alone) {
        const bool was_there = (here_ || is_standing(standing, last)) && standing.is_since(before);
        if (was_there) { // between two bounces
            if (!here_) {
                typename junction_here::cone_list one;
                one.push_back(standing.cone_at(last, kept_.of(last), approach::across, std::nullopt));
                here_.emplace(std::move(one), -velocity(standing, before));
            }
            here_->leave_none();
            here_->head(velocity(standing, x));
        } else {
            leave_junction(standing, before);
            if (!alone) {
                if (auto met = arrival_at(standing, before); met.size() > 0) {
                    here_ = std::move(met);
                    here_->head(velocity(standing, x));
                }
            }
            keep_sides(standing, before, x, {});
        }
        note_sliding(standing, x);
    }

    // It has been given another state. on_the_way: that state is still on its way. From then on, images are counted
    // from that one.
    void restate(const parts& standing, const state& x, bool on_the_way, image_index first) {
        leave_junction(standing, x);
        kept_.count_from(first);
        if (!on_the_way) {
            kept_.clear();
            keeps_aside_ = false;
        }
    }

  private:
    [[nodiscard]] static vec<N, X> velocity(const parts& standing, const state& x) {
        return standing.exactly(x.state.velocity);
    }
    [[nodiscard]] static bool is_standing(const parts& standing, const standing_image& b) noexcept {
        return b.is_any() && b.what >= standing.begin();
    }

    // When it meets b, if nothing stands between them.
    [[nodiscard, gnu::noinline]] meeting meets(const parts& standing, const state& x, const standing_image& b) const {
        const next when = meet(standing, x, b);
        return when == next::as_told  ? standing.meets(b, x)
               : when == next::never  ? meeting::never
               : standing.is_since(x) ? meeting::then
                                      : meeting::elsewhen;
    }
    [[nodiscard, gnu::noinline]] junction_here arrival_at(const parts& standing, const state& x) const {
        return arrival(
            standing, x, [&](const standing_image& b) { return meets(standing, x, b); },
            [&](const standing_image& b) { return side_along(standing, x, b); });
    }
    void arrive(const parts& standing, state& x, const standing_image& b, bool alone) {
        const auto before = velocity(standing, x);
        auto met = alone && !slides(standing, x) ? std::nullopt : std::optional(arrival_at(standing, x));
        standing.bounce(b, x);
        if (met && met->size() > 1) {
            here_ = std::move(met);
            here_->meet(b, before, velocity(standing, x));
        }
    }

    // f(b, side) for all planes and walls of which the point, now x, keeps a side.
    template <class F>
    void for_each_side(const parts& standing, const state& x, F f) const {
        kept_.for_each([&](const standing_image& b, int side) {
            if (!here_ || !here_->has(b)) {
                f(b, side);
            }
        });
        if (here_) {
            here_->leave(velocity(standing, x), f);
        }
    }
    // The side of b, in whose plane x moves: its side of any plane or wall in this plane.
    [[nodiscard]] int side_along(const parts& standing, const state& x, const standing_image& b) const {
        int result = 0;
        for_each_side(standing, x, [&](const standing_image& c, int side) {
            result = result != 0 ? result : side * (c == b ? 1 : standing.common_sense(c, b));
        });
        return result;
    }
    void note_sliding(const parts& standing, const state& x) {
        keeps_aside_ = false;
        for_each_side(standing, x, [&](const standing_image& b, int) {
            keeps_aside_ = keeps_aside_ || standing.heading(b, x) == 0;
        });
    }

    void settle_at_border(const parts& standing, const state& before, const state& x, const standing_image& b,
                          int side) {
        if (standing.rounds()) {
            if (here_ || side == 0 || standing.side(b, x) * side >= 0) {
                return;
            }
            here_ = arrival_at_border(standing, before, x, b,
                                      [&](const standing_image& c) { return side_along(standing, before, c); });
            if (here_) {
                here_->meet(b, velocity(standing, before), velocity(standing, x));
            }
        }
    }
    void leave_junction(const parts& standing, const state& x) {
        if (here_) {
            here_->leave(velocity(standing, x), [&](const standing_image& b, int side) { kept_.keep(b, side); });
            here_.reset();
        }
    }

    // For a point that was at `before` and has become x at that time: keeps the sides from which the rounding of its
    // position has carried it, and those on which it goes on sliding; forgets those on which it is.
    void keep_sides(const parts& standing, const state& before, const state& x, const standing_image& met) {
        const auto is_elsewhere = [&](const standing_image& b) { return b != met && !(here_ && here_->has(b)); };
        if (standing.rounds()) {
            kept_sides kept;
            for (const standing_image& b : standing.near(standing.around(x))) {
                const int side = kept_.of(b);
                kept.keep(b, is_elsewhere(b) ? side_lost(standing, before, x, met, b, side) : side);
            }
            kept_ = std::move(kept);
        } else {
            kept_.keep_if([&](const standing_image& b, int side) {
                return !is_elsewhere(b) || side_lost(standing, before, x, met, b, side) != 0;
            });
        }
    }

    kept_sides kept_;
    std::optional<junction_here> here_;
    bool keeps_aside_ = false; // whether it slides on a known side of a plane or wall
};

} // namespace graze::inline v0_1::detail
