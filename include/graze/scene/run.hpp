// A scene's events one after the other: predict, take the earliest, let those who take part bounce, predict again.
#pragma once

#include <graze/scene/event_heap.hpp>
#include <graze/scene/moving_scene.hpp>
#include <graze/scene/outcome.hpp>

#include <sstream>

namespace graze {

// A run of a scene by mechanics M, from t = 0 on. Balls fly freely between their own events: nothing of a ball is
// computed, or rounded, but by an event in which it takes part.
//
// Order. The earliest event is next, as M orders times. Events of exactly the same time that share no ball are all
// done; of those that share one, which only M's rounding or a choice can tell apart, the first in an order that depends
// on the scene's numbers alone, and the others are predicted again; the run counts them (outcome::choices). The
// sequence and all states are those of the scene, whatever the order of its lists; of two balls whose numbers are all
// the same, either may be called by the other's index.
// Rules. Two that have met are not offered to each other again until one of them has had another event. A point stays
// on the side of a plane or wall from which it came, wherever its position was rounded to. Balls that overlap and
// approach, at the start or later, are resolved at once along their line of centres; a ball that cuts a plane or wall
// and goes deeper, likewise. A ball of infinite mass is a mirror: nothing changes its flight.
// Nothing is lost: when an exception passes, the run stands as it was before the event at hand (or, of the observer's
// own exceptions, after it), and advance may be called again.
template <mechanics M>
class run {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;
    using time = typename M::time;

    // Copies the scene. Throws as check does.
    explicit run(const scene<dimension, number>& s, M m = M()) : scene_(s, std::move(m)) {
        place_.resize(scene_.balls());
        for (body a = 0; a < scene_.balls(); ++a) {
            place_[static_cast<std::size_t>(scene_.name(a))] = a;
        }
        predict_all();
    }

    // Goes on as far as the limits say. The observer is called with a run_event after each event; if it returns
    // something, false stops the run. Throws std::domain_error that names two balls of infinite mass that meet, and
    // whatever M throws.
    template <class Observer = ignore_event>
    outcome advance(const run_limits<number>& limits, Observer&& observer = {}) {
        outcome done{ending::events};
        const std::uint64_t patience =
            limits.cascade != 0 ? limits.cascade : 1000 + 100 * std::uint64_t{scene_.balls()};
        while (done.events < limits.events) {
            if (next_ == due_.size() && !gather()) {
                done.why = ending::exhausted;
                return done;
            }
            const due& d = due_[next_];
            if (scene_.is_stale(d.what)) { // an event of the same time has changed one of the two
                ++next_;
                continue;
            }
            if (limits.time && scene_.rules().order(d.when, *limits.time) > 0) {
                done.why = ending::time;
                return done;
            }
            if (const time_bounds bounds = scene_.rules().bounds(d.when); bounds.lower > still_until_) {
                still_until_ = bounds.upper;
                still_ = 0;
            } else if (still_ >= patience) {
                done.why = ending::cascade;
                return done;
            }
            const bool goes_on = perform(observer);
            ++done.events;
            done.choices += due_[next_ - 1].chosen ? 1 : 0;
            if (!goes_on) {
                done.why = ending::stopped;
                return done;
            }
        }
        return done;
    }

    // The ball of that index of the scene, in flight since its last event.
    [[nodiscard]] const state& in_flight(int index) const noexcept {
        return scene_[place_[static_cast<std::size_t>(index)]].state;
    }
    [[nodiscard]] int balls() const noexcept { return static_cast<int>(scene_.balls()); }
    [[nodiscard]] const M& rules() const noexcept { return scene_.rules(); }

    // Gives every ball another state, f(index, state), as when velocities are turned round, and predicts anew. None of
    // them may be earlier than the last event. What f throws leaves the run as it was.
    template <class F>
    void restate(F f) {
        std::vector<state> states;
        states.reserve(scene_.balls());
        for (body a = 0; a < scene_.balls(); ++a) {
            states.push_back(f(scene_.name(a), std::as_const(scene_)[a].state));
        }
        run changed(*this);
        for (body a = 0; a < scene_.balls(); ++a) {
            changed.scene_[a].state = std::move(states[a]);
            changed.scene_[a].last = detail::no_body;
        }
        changed.predict_all();
        *this = std::move(changed);
    }

  private:
    using body = detail::body;
    using foreseen = detail::foreseen;

    // An event that is next, with its exact time.
    struct due {
        foreseen what;
        time when;
        bool chosen = false;
    };

    // What a and b will do, if anything, goes into found_.
    void offer(body a, body b) {
        if (b < a) {
            std::swap(a, b);
        }
        if (scene_.have_just_met(a, b)) {
            return;
        }
        if (const std::optional<time> when = scene_.meet(a, b)) {
            const time_bounds bounds = scene_.rules().bounds(*when);
            if (bounds.lower <= std::numeric_limits<double>::max()) { // else never, or not a number
                const std::uint32_t count_b = b < scene_.balls() ? scene_[b].count : 0;
                found_.push_back({bounds.lower, bounds.upper, a, b, scene_[a].count, count_b});
            }
        }
    }
    void offer_all(body a) {
        for (body b = 0; b < scene_.bodies(); ++b) {
            if (b != a) {
                offer(a, b);
            }
        }
    }
    void predict_all() {
        heap_.clear();
        due_.clear();
        next_ = 0;
        found_.clear();
        for (body a = 0; a < scene_.balls(); ++a) {
            for (body b = a + 1; b < scene_.bodies(); ++b) {
                offer(a, b);
            }
        }
        heap_.make_room(found_.size());
        keep_found();
    }
    void keep_found() noexcept {
        for (const foreseen& f : found_) {
            heap_.push(f);
        }
    }

    // Fills due_ with all events of exactly the earliest time, in canonical order. False if there is none.
    bool gather() {
        due_.clear();
        next_ = 0;
        nearest_.clear();
        double limit = std::numeric_limits<double>::infinity();
        while (!heap_.empty() && heap_.top().lower <= limit) {
            const foreseen f = heap_.top();
            if (scene_.is_stale(f)) {
                heap_.pop();
                continue;
            }
            nearest_.push_back(f);
            heap_.pop();
            limit = std::min(limit, f.upper);
        }
        try {
            select();
        } catch (...) {
            due_.clear();
            for (const foreseen& f : nearest_) { // there is room: they came from there
                heap_.push(f);
            }
            throw;
        }
        return !due_.empty();
    }

    // Of nearest_, whose bounds do not tell the earliest, those that are go to due_, and the others back.
    void select() {
        const auto key = [](const foreseen& f) { return std::pair(f.a, f.b); };
        std::sort(nearest_.begin(), nearest_.end(),
                  [&](const foreseen& x, const foreseen& y) { return key(x) < key(y); });
        nearest_.erase(std::unique(nearest_.begin(), nearest_.end(),
                                   [&](const foreseen& x, const foreseen& y) { return key(x) == key(y); }),
                       nearest_.end());
        due_.reserve(nearest_.size());
        for (const foreseen& f : nearest_) {
            due d{f, *scene_.meet(f.a, f.b)};
            const int order = due_.empty() ? 0 : order_of(d, due_.front());
            if (order < 0) {
                due_.clear();
            }
            if (order <= 0) {
                due_.push_back(std::move(d));
            }
        }
        for (const foreseen& f : nearest_) {
            const bool is_due =
                std::any_of(due_.begin(), due_.end(), [&](const due& d) { return key(d.what) == key(f); });
            if (!is_due) {
                heap_.push(f);
            }
        }
        mark_choices();
    }
    [[nodiscard]] int order_of(const due& x, const due& y) const {
        try {
            return scene_.rules().order(x.when, y.when);
        } catch (undecided& e) {
            e.between(scene_.named(x.what.a, x.what.b), scene_.named(y.what.a, y.what.b));
            throw;
        }
    }

    // Marks those that share a ball, other than a mirror, with another one.
    void mark_choices() {
        for (due& x : due_) {
            for (const due& y : due_) {
                x.chosen = x.chosen || (&x != &y && (shares(x.what.a, y.what) || shares(x.what.b, y.what)));
            }
        }
    }
    [[nodiscard]] bool shares(body a, const foreseen& f) const noexcept {
        return a < scene_.balls() && !scene_[a].immovable && (a == f.a || a == f.b);
    }

    // Does the event due_[next_].
    template <class Observer>
    bool perform(Observer& observer) {
        const due& d = due_[next_];
        const body a = d.what.a;
        const body b = d.what.b;
        const bool two = b < scene_.balls();
        if (two && scene_[a].immovable && scene_[b].immovable) {
            refuse(d);
        }
        auto before_a = scene_.remember(a);
        auto before_b = scene_.remember(two ? b : a);
        try {
            scene_.bounce(a, b, d.when);
            found_.clear();
            if (!scene_[a].immovable) {
                offer_all(a);
            }
            if (two && !scene_[b].immovable) {
                offer_all(b);
            }
            heap_.make_room(found_.size());
        } catch (...) {
            scene_.restore(a, before_a);
            if (two) {
                scene_.restore(b, before_b);
            }
            throw;
        }
        keep_found();
        ++next_;
        ++still_;
        const run_event<M> told{scene_.named(a, b),
                                d.when,
                                before_a.ball.state,
                                scene_[a].state,
                                two ? &before_b.ball.state : nullptr,
                                two ? &scene_[b].state : nullptr,
                                d.chosen};
        if constexpr (std::is_void_v<decltype(observer(told))>) {
            observer(told);
            return true;
        } else {
            return static_cast<bool>(observer(told));
        }
    }
    [[noreturn]] void refuse(const due& d) const {
        std::ostringstream message;
        message << to_string(scene_.named(d.what.a, d.what.b))
                << ": both masses are infinite, and they meet at about t = " << scene_.rules().bounds(d.when).lower;
        throw std::domain_error(message.str());
    }

    detail::moving_scene<M> scene_;
    std::vector<body> place_; // by the scene's index
    detail::event_heap heap_;
    std::vector<foreseen> found_, nearest_; // here so that an event allocates nothing
    std::vector<due> due_;
    std::size_t next_ = 0; // of due_
    double still_until_ = -std::numeric_limits<double>::infinity();
    std::uint64_t still_ = 0; // events since time last went on for certain
};

} // namespace graze
