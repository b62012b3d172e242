// What the balls of a run will do.
#pragma once

#include <graze/scene/choices.hpp>
#include <graze/scene/event_calendar.hpp>
#include <graze/scene/surroundings.hpp>

#include <limits>

namespace graze::inline v0_1::detail {

// The next event of each ball of a moving scene. A pair belongs to that ball of the two of which the flight or the list
// changed last; a ball's plan is for the earliest of what it may do with those that belong to it, with what stands, and
// with its shell, which it may leave. So what happens first to anyone is in some ball's plan, unless that is stale: its
// partner has changed since, and the ball looks again when its time comes.
//
// A change of the scene is foreseen first, which may throw and then has changed nothing here, and accepted afterwards,
// which does not.
template <mechanics M>
class forecast {
  public:
    static constexpr int dimension = M::dimension;
    using time = typename M::time;

    forecast(moving_scene<M> scene, bool with_cells) : scene_(std::move(scene)), with_cells_(with_cells) {}

    [[nodiscard]] moving_scene<M>& scene() noexcept { return scene_; }
    [[nodiscard]] const moving_scene<M>& scene() const noexcept { return scene_; }

    // Starts anew with the scene as it is; nothing will happen before `now`.
    void predict_all(double now) {
        std::vector<flight<dimension, double>> flights;
        flights.reserve(scene_.balls());
        for (body a = 0; a < scene_.balls(); ++a) {
            flights.push_back(about(a));
        }
        surroundings_ = surroundings<dimension>(flights, now, {scene_.extents(), scene_.balls()}, with_cells_);
        calendar_ = event_calendar(scene_.balls());
        plans_.assign(scene_.balls(), {});
        changed_.resize(scene_.balls());
        pending_.clear();
        start_ = now;
        for (clock_ = 0; clock_ < scene_.balls(); ++clock_) {
            changed_[clock_] = clock_;
        }
        for (body a = 0; a < scene_.balls(); ++a) {
            set(a, look_again(a, now));
        }
    }

    // Foresees what ball a, whose flight has changed at a time not before `now`, will do.
    void foresee(body a, double now) { pending_.push_back({a, look(a, now, true)}); }
    // Marks those of the events due at the time `now`, from one on, that share a ball with what has been foreseen, if
    // it is of just that time.
    void mark_choices(const time& now, std::vector<due<time>>& events, std::size_t from) {
        if (from >= events.size()) {
            return;
        }
        found_.clear();
        const double latest = scene_.rules().bounds(now).upper;
        for (const auto& p : pending_) {
            gather(p.first, latest, true);
        }
        due_balls_.compare(scene_, found_, now, events, from);
    }
    void forget() noexcept { pending_.clear(); }
    void accept() noexcept {
        surroundings_.note_event();
        for (const auto& [a, p] : pending_) {
            changed_[a] = ++clock_;
            set(a, p);
        }
    }

    // Fills events with all of exactly the earliest time, in canonical order. False if there is none.
    bool take_earliest(std::vector<due<time>>& events) {
        events.clear();
        nearest_.clear();
        taken_.clear();
        try {
            double limit = std::numeric_limits<double>::max();
            for (body a = calendar_.earliest(); a != no_body && calendar_.when(a) <= limit; a = calendar_.earliest()) {
                const plan& p = plans_[a];
                if (p.is_to_leave()) {
                    renew(a);
                } else if (is_stale(p)) {
                    set(a, look_again(a, p.lower));
                } else {
                    add_nearest(a, p, limit);
                    if (taken_.empty() && calendar_.is_only_until(limit)) {
                        break;
                    }
                    taken_.push_back(a);
                    calendar_.remove(a);
                }
            }
            put_in_order(nearest_);
            select_earliest(scene_, nearest_, events);
            due_balls_.note(scene_, events);
            put_first_standing_first(scene_, events);
        } catch (...) {
            events.clear();
            return_taken();
            throw;
        }
        return_taken();
        return !events.empty();
    }

  private:
    static constexpr double never = std::numeric_limits<double>::max();

    // The ball meets b not before lower; without b, it leaves its shell then. contested: it may meet another one before
    // it certainly meets b. upper: the latest for what it meets.
    struct plan {
        double lower = never;
        double upper = never;
        body b = no_body;
        std::uint32_t count_b = 0;
        bool contested = false;

        [[nodiscard]] bool is_to_leave() const noexcept { return b == no_body; }
    };

    [[nodiscard]] flight<dimension, double> about(body a) const { return scene_.rules().about(scene_[a].state); }
    void set(body a, const plan& p) noexcept {
        plans_[a] = p;
        calendar_.schedule(a, p.lower);
    }
    [[nodiscard]] bool is_stale(const plan& p) const noexcept {
        return p.b < scene_.balls() && scene_.count(p.b) != p.count_b;
    }
    [[nodiscard]] std::uint32_t count(body b) const noexcept { return b < scene_.balls() ? scene_.count(b) : 0; }

    // Around when a and b meet; never, if they don't or it is certainly later than `latest`.
    [[nodiscard, gnu::always_inline]] time_bounds when(body a, body b, double latest) const {
        constexpr time_bounds none{never, never};
        if (scene_.have_just_met(a, b)) {
            return none;
        }
        const time_bounds bounds = b < a ? scene_.meet_until(b, a, latest) : scene_.meet_until(a, b, latest);
        // not a number, or of mirrors, whose flights began before
        return bounds.lower < never && !(bounds.upper < start_) ? bounds : none;
    }
    // f(b) for those whom a may meet in its shell and who belong to it: all of them, if it has changed.
    template <class F>
    void for_each_own(body a, std::span<const body> list, bool has_changed, F f) const {
        const auto each = [&](body b) {
            if (has_changed || b >= scene_.balls() || changed_[b] < changed_[a]) {
                f(b);
            }
        };
        std::for_each(list.begin(), list.end(), each);
        const auto far = surroundings_.everywhere();
        std::for_each(far.begin(), far.end(), [&](body b) {
            if (b != a) {
                each(b);
            }
        });
    }
    template <class F>
    void for_each_other(body a, bool has_changed, F f) const {
        for (body b = 0; b < scene_.bodies(); ++b) {
            if (b != a && (has_changed || b >= scene_.balls() || changed_[b] < changed_[a])) {
                f(b);
            }
        }
    }
    template <class F>
    void for_each_own(body a, bool has_changed, F f) const {
        if (surroundings_.is_everywhere(a)) {
            for_each_other(a, has_changed, f);
        } else {
            for_each_own(a, surroundings_.of(a), has_changed, f);
        }
    }

    // The earliest of a's own, as `each` passes them on, until it leaves its shell at `end`.
    template <class Each>
    [[nodiscard]] plan earliest_of(body a, double end, Each each) const {
        plan p{never, end};
        double second = never;
        each([&](body b) {
            if (const time_bounds bounds = when(a, b, p.upper); bounds.lower < never) {
                second = std::min(second, std::max(p.lower, bounds.lower));
                if (bounds.lower < p.lower) {
                    p.lower = bounds.lower;
                    p.b = b;
                }
                p.upper = std::min(p.upper, bounds.upper);
            }
        });
        if (p.upper < end || end == never) {
            p.contested = second <= p.upper && second < never;
            p.count_b = p.b < scene_.bodies() ? count(p.b) : 0;
        } else {
            p.lower = std::min(p.lower, end);
            p.b = no_body;
        }
        return p;
    }
    [[nodiscard]] plan look(body a, double now, bool has_changed) const {
        const shell_end<dimension> end = surroundings_.end(a, about(a), now);
        if (!end.known) { // it will have none
            return {now, never};
        }
        return earliest_of(a, end.when, [&](auto f) { for_each_own(a, has_changed, f); });
    }
    [[nodiscard]] plan look_again(body a, double now) const { return look(a, now, false); }

    // Gives ball a another shell. Where it is not certain that it leaves that one after what it meets, a wider one.
    void renew(body a) {
        const double now = plans_[a].lower;
        const auto f = about(a);
        double more = 0;
        for (int tries = 0; tries < 4 && surroundings_.look_around(a, f, now, more); ++tries) {
            const double end = surroundings_.fresh_end(f, now);
            const plan p = earliest_of(a, end, [&](auto meet) { for_each_own(a, surroundings_.fresh(), true, meet); });
            if (!p.is_to_leave() || p.lower == end) {
                surroundings_.make_room(a);
                surroundings_.settle(a);
                changed_[a] = ++clock_;
                set(a, p);
                return;
            }
            double speed = 0;
            for (int i = 0; i < dimension; ++i) {
                speed += std::fabs(f.state.velocity[i]);
            }
            more += 4 * speed * (p.upper - now);
        }
        const plan p = earliest_of(a, never, [&](auto meet) { for_each_other(a, true, meet); });
        surroundings_.spread(a);
        changed_[a] = ++clock_;
        set(a, p);
    }

    // What a may meet until `latest`, into found_.
    void gather(body a, double latest, bool has_changed) {
        for_each_own(a, has_changed, [&](body b) {
            if (const time_bounds bounds = when(a, b, latest); bounds.lower <= latest && bounds.lower < never) {
                const body x = std::min(a, b), y = std::max(a, b);
                found_.push_back({bounds.lower, x, y, scene_.count(x), count(y)});
            }
        });
    }
    void add_nearest(body a, const plan& p, double& limit) {
        found_.clear();
        if (p.contested) {
            gather(a, std::min(limit, p.upper), false);
        } else {
            const body x = std::min(a, p.b), y = std::max(a, p.b);
            found_.push_back({p.lower, x, y, scene_.count(x), count(y)});
        }
        for (const foreseen& f : found_) {
            nearest_.push_back({f, *scene_.meet(f.a, f.b)});
            limit = std::min(limit, scene_.rules().bounds(nearest_.back().when).upper);
        }
    }
    void return_taken() noexcept {
        for (const body a : taken_) {
            calendar_.schedule(a, plans_[a].lower);
        }
    }

    moving_scene<M> scene_;
    surroundings<dimension> surroundings_;
    event_calendar calendar_;
    std::vector<plan> plans_;
    std::vector<std::uint64_t> changed_; // when a ball's flight or list has changed, counted by clock_
    std::uint64_t clock_ = 0;
    bool with_cells_;
    double start_ = 0;                           // of the predictions
    std::vector<std::pair<body, plan>> pending_; // this and what follows stand here so that an event allocates nothing
    std::vector<foreseen> found_;
    std::vector<due<time>> nearest_;
    std::vector<body> taken_;
    due_balls due_balls_;
};

} // namespace graze::inline v0_1::detail
