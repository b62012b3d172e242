// What the balls of a run will do.
#pragma once

#include <graze/scene/cell_grid.hpp>
#include <graze/scene/choices.hpp>

#include <limits>

namespace graze::inline v0_1::detail {

// Predictions of a moving scene, kept in a heap. A change of the scene is foreseen first, which may throw and then has
// changed nothing here, and accepted afterwards, which does not.
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
        cells_ = cell_grid<dimension>(flights, now, with_cells_);
        heap_.clear();
        start_ = now;
        for (body a = 0; a < scene_.balls(); ++a) {
            forget();
            predict(a, a + 1);
            heap_.make_room(found_.size());
            accept();
        }
    }

    // Foresees what ball a, whose flight has changed, will do, beside what has been foreseen since forget.
    void foresee(body a) {
        predict(a, 0);
        heap_.make_room(found_.size());
    }
    // Marks those of the events due at the time `now`, from one on, that share a ball with what has been foreseen, if
    // it is of just that time.
    void mark_choices(const time& now, std::vector<due<time>>& events, std::size_t from) const {
        due_balls_.compare(scene_, found_, now, events, from);
    }
    void forget() noexcept {
        found_.clear();
        lost_.clear();
    }
    void accept() noexcept {
        for (const foreseen& f : found_) {
            heap_.push(f);
        }
        for (const body a : lost_) {
            cells_.spread(a);
        }
        if (heap_.size() > worth_a_purge_) {
            heap_.purge([&](const foreseen& f) { return is_stale(f); });
            worth_a_purge_ = 2 * heap_.size() + 4 * std::size_t{scene_.balls()} + 1024;
        }
    }

    // Fills events with all of exactly the earliest time, in canonical order, and takes them out. False if there is
    // none.
    bool take_earliest(std::vector<due<time>>& events) {
        events.clear();
        nearest_.clear();
        try {
            double limit = std::numeric_limits<double>::max();
            while (heap_.has_top([&](const foreseen& f) { return is_stale(f); }) && heap_.top().lower <= limit) {
                const foreseen f = heap_.top();
                if (is_stale(f)) {
                    heap_.pop();
                } else if (is_crossing(f)) {
                    cross();
                } else {
                    nearest_.push_back({f, *scene_.meet(f.a, f.b)});
                    heap_.pop();
                    limit = std::min(limit, scene_.rules().bounds(nearest_.back().when).upper);
                }
            }
            put_in_order(nearest_);
            select_earliest(scene_, nearest_, events);
            due_balls_.note(scene_, events);
            put_first_standing_first(scene_, events);
        } catch (...) {
            events.clear();
            return_nearest(events);
            throw;
        }
        return_nearest(events);
        return !events.empty();
    }

  private:
    [[nodiscard]] flight<dimension, double> about(body a) const { return scene_.rules().about(scene_[a].state); }

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
            const bool is_past = bounds.upper < start_; // of mirrors, whose flights began before
            if (bounds.lower < std::numeric_limits<double>::max() && !is_past) { // else never, or not a number
                const std::uint32_t count_b = b < scene_.balls() ? scene_.count(b) : 0;
                found_.push_back({bounds.lower, a, b, scene_.count(a), count_b});
            }
        }
    }
    // Offers a to those that `those` passes on, but for what comes before `from`: first all of them are fetched from
    // memory, which is far away when there are many balls, and then one after the other is looked at.
    template <class F>
    void offer_each(body a, body from, F those) {
        neighbours_.clear();
        those([&](body b) {
            if (b >= from) {
                scene_.fetch(b);
                neighbours_.push_back(b);
            }
        });
        for (const body b : neighbours_) {
            offer(a, b);
        }
    }
    void offer_standing(body a) {
        for (body b = scene_.balls(); b < scene_.bodies(); ++b) {
            offer(a, b);
        }
    }
    void expect(int level, body a, const face_crossing& c) {
        if (c.step != 0) {
            found_.push_back({c.when, a, crossing_of(level), scene_.count(a), 0});
        }
    }
    // Everything that ball a will do with others, those before `from` left out. A ball that the cells lose is offered
    // to everyone from then on.
    void predict(body a, body from) {
        bool lost = false;
        if (!cells_.is_everywhere(a)) {
            const auto f = about(a);
            for (int level = cells_.first_level(a); level < cells_.levels(); ++level) {
                const auto c = cells_.next_crossing(level, a, f);
                lost = lost || !cells_.resolves(level, c, f);
                expect(level, a, c);
            }
        }
        if (lost) {
            lost_.push_back(a);
            offer_everyone(a);
        } else {
            offer_each(a, from, [&](auto take) { cells_.around(a, take); });
        }
        offer_standing(a);
    }
    void offer_everyone(body a) {
        for (body b = 0; b < scene_.balls(); ++b) {
            if (b != a) {
                offer(a, b);
            }
        }
    }

    [[nodiscard]] bool is_stale(const foreseen& f) const noexcept {
        return scene_.is_stale(f) || (is_crossing(f) && cells_.is_everywhere(f.a));
    }

    // The ball of the heap's top moves on to the next cell.
    void cross() {
        const foreseen f = heap_.top();
        const int level = level_of(f);
        const auto flight_a = about(f.a);
        const auto crossed = cells_.next_crossing(level, f.a, flight_a);
        const auto next = cells_.next_crossing(level, f.a, flight_a, crossed);
        forget();
        if (cells_.resolves(level, next, flight_a)) {
            offer_each(f.a, 0, [&](auto take) { cells_.ahead(level, f.a, crossed, take); });
            expect(level, f.a, next);
        } else {
            lost_.push_back(f.a);
            offer_everyone(f.a);
        }
        heap_.make_room(found_.size() + nearest_.size());
        heap_.pop();
        cells_.cross(level, f.a, crossed);
        accept();
    }

    // What is not among the events goes back, for which there is room: it came from there.
    void return_nearest(const std::vector<due<time>>& events) noexcept {
        auto taken = events.begin();
        for (const auto& d : nearest_) {
            if (taken != events.end() && is_of_same_bodies(taken->what, d.what)) {
                ++taken;
            } else {
                heap_.push(d.what);
            }
        }
    }

    moving_scene<M> scene_;
    cell_grid<dimension> cells_;
    event_heap heap_;
    bool with_cells_;
    double start_ = 0;                 // of the predictions
    std::size_t worth_a_purge_ = 1024; // so many entries of the heap
    std::vector<foreseen> found_;      // this and the next stand here so that an event allocates nothing
    std::vector<due<time>> nearest_;
    std::vector<body> neighbours_, lost_;
    due_balls due_balls_;
};

} // namespace graze::inline v0_1::detail
