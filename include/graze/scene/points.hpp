// Balls of radius 0 among planes and walls: what they meet at an instant, and on which side of what they stay.
#pragma once

#include <graze/scene/junction.hpp>
#include <graze/scene/kept_sides.hpp>
#include <graze/scene/standing.hpp>

#include <optional>

namespace graze::inline v0_1::detail {

// What a run knows of one point beside its state.
//
// Two things can bring a point to several planes and walls at once. They really meet at one place: then all of them are
// met at exactly the same time, and a junction tells what happens, by the exact directions. Or a position was rounded,
// which may carry a point beyond what it had not reached, or had just left: then its side of that is kept until it is
// there, and if it heads for the other side, it is turned back.
template <mechanics M>
class point_among {
  public:
    using state = typename M::state;
    using time = typename M::time;
    using parts = standing_parts<M>;
    using junction_here = junction<M::dimension, typename M::exact>;

    // When it meets b, which it has not just met.
    [[nodiscard]] std::optional<time> meet(const M& m, const parts& standing, const state& x, body b) const {
        if (here_ && here_->has(b)) {
            return here_->next() == b ? std::optional<time>(m.now(x)) : std::nullopt;
        }
        return standing.with(b, [&](const auto& s) -> std::optional<time> {
            if (const int side = kept_.of(b); side != 0 && is_beyond(m, x, s, side)) {
                return m.heading(x, s) * side < 0 ? std::optional<time>(m.now(x)) : std::nullopt;
            }
            return m.meet(x, s);
        });
    }

    // Which of those that it meets at exactly this time is the first.
    [[nodiscard]] body first_at(const M& m, const parts& standing, const state& x, const time& when) const {
        if (here_ && here_->next() != no_body) {
            return here_->next();
        }
        auto met = junction_at(m, standing, x, when);
        met.head(velocity(m, x));
        return met.next();
    }

    // It meets b at that time; alone: and nothing else.
    void bounce(const M& m, const parts& standing, state& x, body b, const time& when, bool alone) {
        const state before = x;
        if (here_ && here_->next() == b) {
            standing.with(b, [&](const auto& s) { m.turn_back(x, s); });
            here_->meet(b, velocity(m, before), velocity(m, x));
            return;
        }
        leave_junction(m, x);
        const int from = standing.with(b, [&](const auto& s) { return -m.heading(x, s); });
        if (const int side = kept_.of(b);
            side != 0 && standing.with(b, [&](const auto& s) { return is_beyond(m, x, s, side); })) {
            standing.with(b, [&](const auto& s) { m.turn_back(x, s); });
            settle_at_border(m, standing, before, x, b, side);
            return;
        }
        auto met = alone && !slides(m, standing, x) ? std::nullopt : std::optional(junction_at(m, standing, x, when));
        standing.with(b, [&](const auto& s) { m.bounce(x, s, when); });
        if (met && met->size() > 1) {
            here_ = std::move(met);
            here_->meet(b, velocity(m, before), velocity(m, x));
        }
        keep_sides(m, standing, before, x, when, b);
        kept_.keep(b, from);
        settle_at_border(m, standing, before, x, b, from);
    }

    // It has met a ball at that time and is now x; last is what it met before. alone: and nothing else.
    void meet_ball(const M& m, const parts& standing, const state& before, const state& x, body last, const time& when,
                   bool alone) {
        const bool was_there = (here_ || is_standing(standing, last)) && m.order(when, m.now(before)) == 0;
        if (was_there) { // between two bounces
            if (!here_) {
                here_.emplace(std::vector{standing.cone_at(m, last, kept_.of(last), false, std::nullopt)},
                              -velocity(m, before));
            }
            here_->leave_none();
            here_->head(velocity(m, x));
            return;
        }
        leave_junction(m, before);
        if (!alone) {
            if (auto met = junction_at(m, standing, before, when); met.size() > 0) {
                here_ = std::move(met);
                here_->head(velocity(m, x));
            }
        }
        keep_sides(m, standing, before, x, when, no_body);
    }

    // It has been given another state, which is still on its way or not.
    void restate(const M& m, const state& x, bool on_the_way) {
        leave_junction(m, x);
        if (!on_the_way) {
            kept_.clear();
        }
    }

  private:
    [[nodiscard]] static vec<M::dimension, typename M::exact> velocity(const M& m, const state& x) {
        return parts::exactly(m, x.state.velocity);
    }
    // Whether x is on s or on the side on which it does not belong.
    template <class S>
    [[nodiscard]] static bool is_beyond(const M& m, const state& x, const S& s, int side) {
        return m.side(x, s) * side <= 0;
    }
    [[nodiscard]] static bool is_standing(const parts& standing, body b) noexcept {
        return b != no_body && b >= standing.begin();
    }

    // Whether x moves in the plane of anything.
    [[nodiscard]] static bool slides(const M& m, const parts& standing, const state& x) {
        for (body b = standing.begin(); b < standing.end(); ++b) {
            if (standing.with(b, [&](const auto& s) { return m.heading(x, s) == 0 && m.side(x, s) == 0; })) {
                return true;
            }
        }
        return false;
    }
    // All that x meets at exactly this time, and all along which it slides then.
    [[nodiscard]] junction_here junction_at(const M& m, const parts& standing, const state& x, const time& when) const {
        struct touched {
            body what;
            int side;
            bool slid_along;
        };
        std::vector<touched> all;
        std::optional<typename parts::place> apex;
        const double latest = m.bounds(when).upper;
        for (body b = standing.begin(); b < standing.end(); ++b) {
            const std::optional<time> t = meet(m, standing, x, b);
            const int side = standing.with(b, [&](const auto& s) { return -m.heading(x, s); });
            if (t && m.bounds(*t).lower <= latest && m.order(*t, when) == 0) {
                all.push_back({b, side, false});
                if (side != 0 && !apex) {
                    apex = standing.crossing(m, b, x, x);
                }
            } else if (!t && side == 0 && standing.with(b, [&](const auto& s) { return m.side(x, s) == 0; })) {
                all.push_back({b, 0, true});
            }
        }
        std::vector<cone<M::dimension, typename M::exact>> cones;
        for (const touched& c : all) {
            if (!c.slid_along || (apex && standing.is_at(m, c.what, *apex))) {
                cones.push_back(standing.cone_at(m, c.what, c.side, c.slid_along, apex));
            }
        }
        return {std::move(cones), velocity(m, x)};
    }
    // A point that came from `side` and left b, but is rounded to beyond it and comes back beside it, has been as near
    // to b's border as rounding goes: there it meets what it would meet at the border itself, shifted into b.
    void settle_at_border(const M& m, const parts& standing, const state& before, const state& x, body b, int side) {
        if constexpr (M::rounds) {
            if (here_ || side == 0 || standing.with(b, [&](const auto& s) { return m.side(x, s) * side >= 0; })) {
                return;
            }
            const auto back = standing.crossing(m, b, x, x);
            if (standing.is_inside(m, b, back)) {
                return;
            }
            const auto border = standing.nearest(m, b, back);
            std::vector<cone<M::dimension, typename M::exact>> cones;
            for (body c = standing.begin(); c < standing.end(); ++c) {
                if (standing.is_in_plane(m, c, border) && standing.is_at(m, c, border)) {
                    const int from = standing.with(c, [&](const auto& s) { return -m.heading(before, s); });
                    cones.push_back(standing.cone_at(m, c, from, from == 0, border));
                }
            }
            here_.emplace(std::move(cones), velocity(m, before));
            here_->meet(b, velocity(m, before), velocity(m, x));
        }
    }
    void leave_junction(const M& m, const state& x) {
        if (here_) {
            here_->leave(velocity(m, x), [&](body b, int side) { kept_.keep(b, side); });
            here_.reset();
        }
    }

    // Keeps the sides from which the rounding of its position has carried a point that was at `before` and, at that
    // time, has become x; forgets those on which it is.
    void keep_sides(const M& m, const parts& standing, const state& before, const state& x, const time& when,
                    body met) {
        if constexpr (M::rounds) {
            for (body b = standing.begin(); b < standing.end(); ++b) {
                if (b != met && !(here_ && here_->has(b))) {
                    kept_.keep(b, side_lost(m, standing, before, x, when, b));
                }
            }
        }
    }
    // The side of b on which the point belongs and x is not, or 0.
    [[nodiscard]] int side_lost(const M& m, const parts& standing, const state& before, const state& x,
                                const time& when, body b) const {
        return standing.with(b, [&](const auto& s) {
            const int kept = kept_.of(b);
            const int heading = m.heading(before, s);
            int side = kept != 0 ? kept : m.side(before, s);
            side = side != 0 ? side : heading != 0 ? heading : m.heading(x, s); // where it slid along b
            if (side == 0 || m.side(x, s) == side) {
                return 0;
            }
            if (side * heading < 0 && !(kept != 0 && is_beyond(m, before, s, kept))) { // it was coming nearer
                const int passed = m.order(when, m.reach(before, s));
                side = passed > 0 ? -side : passed < 0 ? side : 0; // beside b, whose plane it may just have reached
            }
            return side != 0 && m.side(x, s) != side && standing.is_at(m, b, standing.crossing(m, b, x, before)) ? side
                                                                                                                 : 0;
        });
    }

    kept_sides kept_;
    std::optional<junction_here> here_;
};

} // namespace graze::inline v0_1::detail
