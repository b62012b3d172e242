// The predicted events of a run's balls.
#pragma once

#include <graze/run/choices.hpp>
#include <graze/run/outcome.hpp>
#include <graze/run/planned_balls.hpp>
#include <graze/scene/records.hpp>

#include <limits>
#include <stdexcept>

namespace graze::inline v0_1::detail {

// The next event of each ball of a moving scene. A ball's plan is the earliest that it may do: meet a partner of a pair
// that belongs to it, meet a plane or wall, or leave its shell. So the first event of all is in some ball's plan,
// unless that is stale: if its partner has changed since, the ball looks again when its time comes.
//
// A change of the scene is predicted first; if that throws, nothing here has changed. It is accepted afterwards, which
// does not throw.
template <mechanics M>
class forecast : public planned_balls<M> {
  public:
    static constexpr int dimension = M::dimension;
    using time = typename M::time;

    using planned_balls<M>::planned_balls;

    // Starts anew with the scene as it is; nothing will happen before `now`.
    void predict_all(double now) {
        this->look_out(now);
        this->begin_to_plan();
        pending_.clear();
        for (body a = 0; a < scene_.balls(); ++a) {
            set(a, look_again(a, now));
        }
    }

    // Predicts the next event of ball a, whose flight has changed at a time not before `now`.
    void predict(body a, double now) { pending_.push_back({a, look(a, now, true)}); }
    // Marks the events at the time `now`, from number `from` on, that share a ball with a predicted event, if that has
    // exactly the same time.
    void mark_choices(const time& now, records<timed_event<time>>& events, std::size_t from) {
        if (from >= events.size()) {
            return;
        }
        found_.clear();
        const double latest = scene_.rules().bounds(now).upper;
        for (const auto& p : pending_) {
            gather(p.a, latest, true);
        }
        balls_of_events_.compare(scene_, found_, now, events, from);
    }
    void forget() noexcept { pending_.clear(); }
    void accept() noexcept {
        surroundings_.idle().note_event();
        for (const auto& [a, p] : pending_) {
            this->note_flight(a);
            set(a, p);
        }
    }

    // Fills events with all of exactly the earliest time, in canonical order. Without any, says why: there will never
    // be one, or, in a scene that has a period, none up to `until` or for long.
    ending take_earliest(records<timed_event<time>>& events, double until) {
        events.clear();
        nearest_.clear();
        taken_.clear();
        try {
            double limit = scene_.is_periodic() ? until : never;
            for (body a = calendar_.earliest(); a != no_body && calendar_.when(a) <= limit; a = calendar_.earliest()) {
                this->fetch_ahead();
                const plan& p = plans_[a];
                if (p.is_to_leave()) {
                    if (scene_.is_periodic() && taken_.empty()) {
                        if (surroundings_.idle().has_idled() && moves_as_one()) {
                            return ending::exhausted;
                        }
                        if (surroundings_.idle().is_idle()) {
                            surroundings_.idle().note_event();
                            return ending::idle;
                        }
                    }
                    renew(a);
                } else if (is_stale(p) || !add_nearest(a, p, limit)) {
                    set(a, look_again(a, p.lower));
                } else {
                    if (taken_.empty() && calendar_.is_only_until(limit)) {
                        break;
                    }
                    taken_.push_back(a);
                    calendar_.remove(a);
                }
            }
            put_in_order(nearest_);
            select_earliest(scene_, nearest_, events);
            balls_of_events_.note(scene_, events);
            put_first_standing_first(scene_, events);
        } catch (...) {
            events.clear();
            return_taken();
            throw;
        }
        return_taken();
        return !events.empty()                                 ? ending::events
               : calendar_.earliest() == no_body               ? ending::exhausted
               : calendar_.when(calendar_.earliest()) == never ? ending::exhausted
                                                               : ending::time;
    }

  private:
    // The next event of a ball that has changed.
    struct change {
        body a;
        plan next;
    };

    using planned_balls<M>::never;
    using planned_balls<M>::scene_;
    using planned_balls<M>::surroundings_;
    using planned_balls<M>::about;
    using planned_balls<M>::count;
    using planned_balls<M>::when;
    using typename planned_balls<M>::no_image;
    using typename planned_balls<M>::listed_image;
    using planned_balls<M>::look;
    using planned_balls<M>::calendar_;
    using planned_balls<M>::plans_;
    using planned_balls<M>::is_stale;
    using planned_balls<M>::set;

    // Whether all balls fly alike and there are no planes or walls, so that nothing more will ever happen.
    [[nodiscard]] bool moves_as_one() const {
        bool alike = scene_.bodies() == scene_.balls();
        for (body a = 1; a < scene_.balls(); ++a) {
            alike = alike && order_of(scene_[a].state.state.velocity, scene_[0].state.state.velocity) == 0;
        }
        return alike;
    }
    [[nodiscard]] plan look_again(body a, double now) { return look(a, now, false); }

    // Gives ball a another shell: a wider one if it is not certain that its next event comes before it leaves.
    void renew(body a) {
        const double now = plans_[a].lower;
        const auto f = about(a);
        const bool settled = this->is_settled(taken_.empty() ? now : plans_[taken_.front()].lower);
        double more = 0;
        for (int tries = 0; tries < 4 && !settled && surroundings_.look_around(a, f, now, scene_.gone(a), more);
             ++tries) {
            const double end = surroundings_.fresh_end();
            const plan p = this->earliest(a, end, this->listed_next(), true);
            if (!p.is_to_leave() || p.lower == end) {
                surroundings_.make_room(a);
                surroundings_.settle(a);
                this->note_place(a);
                this->note_change(a);
                set(a, p);
                return;
            }
            double speed = 0;
            for (int i = 0; i < dimension; ++i) {
                speed += std::fabs(f.state.velocity[i]);
            }
            more += 4 * speed * (p.upper - now);
        }
        if (scene_.is_periodic()) {
            this->refuse(a);
        }
        const plan p = this->earliest(a, never, settled ? this->remaining(a) : this->everyone(), true);
        surroundings_.spread(a);
        this->note_change(a);
        set(a, p);
    }

    void find(body a, body b, image_index image, double lower) {
        const body x = std::min(a, b), y = std::max(a, b);
        found_.push_back({lower, x, y, scene_.count(x), count(y), x == a ? image : image_index{} - image});
    }
    // Writes what a may meet until `latest` to found_. Returns by when it certainly meets one of these.
    double gather(body a, double latest, bool has_changed) {
        double upper = never;
        const auto look_at = [&](body b, image_index image) {
            if (const time_bounds bounds = when(a, b, image, latest); bounds.lower <= latest && bounds.lower < never) {
                find(a, b, image, bounds.lower);
                upper = std::min(upper, bounds.upper);
            }
        };
        const auto each = [&](body b, const auto& image) { look_at(b, this->index_of(a, b, image)); };
        const auto near = this->neighbours_of(a);
        if (scene_.is_periodic()) {
            this->template for_each_own<listed_image>(a, near, has_changed, latest, each, each);
        } else {
            this->template for_each_own<no_image>(a, near, has_changed, latest, each, each);
        }
        return upper;
    }
    // False, and adds nothing, if it is no longer certain that a meets something until p.upper: what it would have met
    // has changed.
    [[nodiscard]] bool add_nearest(body a, const plan& p, double& limit) {
        found_.clear();
        if (p.contested) {
            const double latest = std::min(limit, p.upper);
            if (gather(a, latest, false) > latest && latest < limit) {
                return false;
            }
        } else {
            find(a, p.b, p.image, p.lower);
        }
        for (const predicted& f : found_) {
            nearest_.push_back({f, *scene_.meet(f.a, f.b, f.image)});
            limit = std::min(limit, scene_.rules().bounds(nearest_.back().when).upper);
        }
        return true;
    }
    void return_taken() noexcept {
        for (const body a : taken_) {
            calendar_.schedule(a, plans_[a].lower);
        }
    }

    records<change> pending_; // members, so that an event allocates nothing
    records<predicted> found_;
    records<timed_event<time>> nearest_;
    records<body> taken_;
    balls_of_events balls_of_events_;
};

} // namespace graze::inline v0_1::detail
