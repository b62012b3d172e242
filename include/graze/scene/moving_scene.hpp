// The parts of a scene while a run changes them, and the questions about them.
#pragma once

#include <graze/scene/canonical_order.hpp>
#include <graze/scene/check_scene.hpp>
#include <graze/scene/kept_sides.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/scene/mover.hpp>

#include <utility>

namespace graze::inline v0_1::detail {

// Balls, planes and walls in their canonical order, by which everything here is numbered, so that nothing depends on
// the order in which the scene lists them.
template <mechanics M>
class moving_scene {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;
    using time = typename M::time;

    moving_scene(const scene<dimension, number>& s, M m) : mechanics_(std::move(m)) {
        check(s);
        const auto sorted = [](const auto& pieces, std::vector<int>& names) {
            names = canonical_order(pieces);
            std::vector<std::remove_cvref_t<decltype(pieces[0])>> result;
            result.reserve(names.size());
            for (const int i : names) {
                result.push_back(pieces[static_cast<std::size_t>(i)]);
            }
            return result;
        };
        planes_ = sorted(s.planes, plane_names_);
        walls_ = sorted(s.walls, wall_names_);
        ball_names_ = canonical_order(s.balls);
        movers_.reserve(ball_names_.size());
        bool points = false;
        for (const int i : ball_names_) {
            mover<state> b{mechanics_.start(s.balls[static_cast<std::size_t>(i)])};
            b.immovable = mechanics_.immovable(b.state);
            b.point = mechanics_.is_point(b.state);
            points = points || b.point;
            movers_.push_back(std::move(b));
        }
        counts_.resize(movers_.size());
        kept_.resize(points && bodies() > balls() ? movers_.size() : 0);
    }

    [[nodiscard]] const M& rules() const noexcept { return mechanics_; }
    [[nodiscard]] body balls() const noexcept { return static_cast<body>(movers_.size()); }
    [[nodiscard]] body bodies() const noexcept {
        return static_cast<body>(movers_.size() + planes_.size() + walls_.size());
    }
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
        if (b < balls()) {
            return {partner::ball, name(a), name(b)};
        }
        const std::size_t standing = b - balls();
        return standing < planes_.size() ? meeting{partner::plane, name(a), plane_names_[standing]}
                                         : meeting{partner::wall, name(a), wall_names_[standing - planes_.size()]};
    }

    [[nodiscard]] bool is_stale(const foreseen& f) const noexcept {
        return counts_[f.a] != f.count_a || (f.b < balls() && counts_[f.b] != f.count_b);
    }

    // Whether the two have just met: neither has had another event since, and both fly straight, so that they part.
    // What meets an immovable ball changes nothing for that ball.
    [[nodiscard]] bool have_just_met(body a, body b) const noexcept {
        const auto turned = [&](body x, body y) { return !movers_[x].immovable && movers_[x].last != y; };
        return b < balls() ? !turned(a, b) && !turned(b, a) && (movers_[a].last == b || movers_[b].last == a)
                           : movers_[a].last == b;
    }

    // When a and b meet, a < b; empty if they don't.
    [[nodiscard]] std::optional<time> meet(body a, body b) const {
        try {
            if (b < balls()) {
                return mechanics_.meet(movers_[a].state, movers_[b].state);
            }
            return with_standing(b, [&](const auto& s) { return meet_standing(a, b, s); });
        } catch (graze::undecided& e) {
            e.between(named(a, b));
            throw;
        } catch (const std::domain_error& e) { // parallel edges, or what restate was given
            throw std::domain_error(to_string(named(a, b)) + ": " + e.what());
        }
    }

    // Ball a's state, and b's if it is a ball, after they have met.
    void bounce(body a, body b, const time& when) {
        try {
            change(a, b, when);
        } catch (graze::undecided& e) {
            e.between(named(a, b));
            throw;
        } catch (const std::overflow_error& e) {
            throw std::overflow_error(to_string(named(a, b)) + ": " + e.what());
        }
    }

    // What bounce changes of a ball, to put it back.
    struct memory {
        mover<state> ball;
        std::uint32_t count;
        kept_sides kept;
    };
    [[nodiscard]] memory remember(body a) const {
        return {movers_[a], counts_[a], kept_.empty() ? kept_sides{} : kept_[a]};
    }
    void restore(body a, memory& m) noexcept {
        movers_[a] = std::move(m.ball);
        counts_[a] = m.count;
        if (!kept_.empty()) {
            kept_[a] = m.kept;
        }
    }

    // Gives ball a another state. A point that is still on its way, but for rounding, keeps the sides on which it
    // belongs; elsewhere they would mean nothing.
    void restate(body a, state other) {
        const flight<dimension, double> f = mechanics_.about(movers_[a].state), g = mechanics_.about(other);
        if (!kept_.empty() && !is_on_the_way(f, g)) {
            kept_[a] = {};
        }
        const bool flies_on = movers_[a].immovable && is_same_flight(f, g);
        movers_[a].state = std::move(other);
        movers_[a].last = flies_on ? movers_[a].last : no_body;
    }

  private:
    void change(body a, body b, const time& when) {
        mover<state>& x = movers_[a];
        const std::optional<state> before_a = before_standing(a);
        if (b < balls()) {
            const std::optional<state> before_b = before_standing(b);
            mechanics_.bounce(x.state, movers_[b].state, when);
            movers_[b].last = a;
            counts_[b] += movers_[b].immovable ? 0 : 1;
            keep_due(b, before_b);
            tidy(b);
        } else {
            with_standing(b, [&](const auto& s) { bounce_standing(a, b, s, when); });
        }
        x.last = b;
        counts_[a] += x.immovable ? 0 : 1;
        keep_due(a, before_a, b);
        tidy(a, b);
    }

    template <class F>
    decltype(auto) with_standing(body b, F f) const {
        const std::size_t standing = b - balls();
        return standing < planes_.size() ? f(planes_[standing]) : f(walls_[standing - planes_.size()]);
    }

    // Whether the rounding of a point's position has carried it across b, or onto it.
    template <class S>
    [[nodiscard]] bool is_beyond(body a, const S& s, int side) const {
        return side != 0 && mechanics_.side(movers_[a].state, s) * side <= 0;
    }
    [[nodiscard]] int kept_side(body a, body b) const noexcept { return kept_.empty() ? 0 : kept_[a].of(b); }

    template <class S>
    [[nodiscard]] std::optional<time> meet_standing(body a, body b, const S& s) const {
        if (const int side = kept_side(a, b); is_beyond(a, s, side)) {
            return mechanics_.heading(movers_[a].state, s) * side < 0
                       ? std::optional<time>(mechanics_.now(movers_[a].state))
                       : std::nullopt;
        }
        return mechanics_.meet(movers_[a].state, s);
    }

    template <class S>
    void bounce_standing(body a, body b, const S& s, const time& when) {
        state& x = movers_[a].state;
        if (is_beyond(a, s, kept_side(a, b))) {
            mechanics_.turn_back(x, s);
            return;
        }
        const int from = kept_.empty() || !movers_[a].point ? 0 : -mechanics_.heading(x, s);
        mechanics_.bounce(x, s, when);
        if (from != 0) {
            kept_[a].keep(b, from);
        }
    }

    // The state before a bounce of a point that something standing may meet.
    [[nodiscard]] std::optional<state> before_standing(body a) const {
        return kept_.empty() || !movers_[a].point || movers_[a].immovable ? std::nullopt
                                                                          : std::optional<state>(movers_[a].state);
    }
    // Keeps the sides on which a point was of what it was yet to meet and where it now is, or beyond: it has come to a
    // corner, or as near to one as rounding goes.
    void keep_due(body a, const std::optional<state>& before, body left = no_body) {
        for (body b = before ? balls() : bodies(); b < bodies(); ++b) {
            if (b == left || kept_side(a, b) != 0) {
                continue;
            }
            with_standing(b, [&](const auto& s) {
                if (mechanics_.meet(*before, s)) {
                    const int side = -mechanics_.heading(*before, s);
                    if (is_beyond(a, s, side)) {
                        kept_[a].keep(b, side);
                    }
                }
            });
        }
    }

    // Forgets the sides of a point that is where it belongs; of the plane or wall that it has just left it is asked at
    // its next event.
    void tidy(body a, body left = no_body) {
        if (kept_.empty() || !movers_[a].point) {
            return;
        }
        kept_[a].forget_if([&](body b, int side) {
            return b != left && with_standing(b, [&](const auto& s) { return !is_beyond(a, s, side); });
        });
    }

    M mechanics_;
    std::vector<mover<state>> movers_;
    std::vector<std::uint32_t> counts_; // beside one another, for they are asked of far more than flights are
    std::vector<kept_sides> kept_;      // of the points, if there are any and something that they can cross
    std::vector<plane<dimension, number>> planes_;
    std::vector<wall<dimension, number>> walls_;
    std::vector<int> ball_names_, plane_names_, wall_names_;
};

} // namespace graze::inline v0_1::detail
