// A scene's events one after the other: predict, take the earliest, let its two bounce, predict again.
#pragma once

#include <graze/run/grazed_balls.hpp>
#include <graze/run/outcome.hpp>
#include <graze/run/run_steps.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace graze::inline v0_1 {

// A run of a scene by mechanics M, from t = 0 on. Balls fly freely between their own events: only an event in which a
// ball takes part computes or rounds anything of it.
//
// Order. The earliest event is next, as M orders times. Events of exactly the same time that share no ball are all
// done. Of those that share one, which only M's rounding or a choice can tell apart, the first is done, in an order
// that depends on the scene's numbers alone, and the others are predicted again; after a graze, which changes no
// velocity, they happen as well. The run counts them (outcome::choices). Where M cannot tell the order of two events
// that share no ball, either is done first. The sequence and all states depend on the scene alone, not on the order of
// its lists; of two balls whose numbers are all the same, either may be called by the other's index. Rules. Two that
// have met are not offered to each other again until one of them has had another event. A point stays on the side of a
// plane or wall from which it came, wherever its position was rounded to. Balls that overlap and approach, at the start
// or later, are resolved at once along their line of centres; so is a ball that cuts a plane or wall and goes deeper. A
// ball of infinite mass is a mirror: nothing changes its flight. Nothing is lost: after an exception the run is as it
// was before the current event (after it, if the observer threw), and advance may be called again.
template <mechanics M>
class run {
  public:
    static constexpr int dimension = M::dimension;
    using number = typename M::number;
    using state = typename M::state;
    using time = typename M::time;

    // Copies the scene. Throws as check and first_events do.
    explicit run(const scene<dimension, number>& s, M m = M(), cells use = cells::where_useful);

    // Goes on as far as the limits say. The observer is called with a run_event after each event; if it returns
    // something, false stops the run. Throws std::domain_error that names two balls of infinite mass that meet, or that
    // says that the time limit is NaN, and whatever M throws.
    template <class Observer = ignore_event>
    outcome advance(const run_limits<number>& limits, Observer&& observer = {}) {
        const auto tell = [&](const run_event<M>& told) { return detail::tell(observer, told); };
        return go_on(limits, listener(tell));
    }

    // The ball of that index of the scene, in flight since its last event.
    [[nodiscard]] const state& in_flight(int index) const noexcept {
        return scene()[place_[static_cast<std::size_t>(index)]].state;
    }
    [[nodiscard]] int balls() const noexcept { return static_cast<int>(scene().balls()); }
    [[nodiscard]] const M& rules() const noexcept { return scene().rules(); }

    // Gives every ball another state, f(index, state), as when velocities are turned round, and predicts anew. Overlaps
    // are treated as at the start. Throws std::domain_error that names a ball whose state is not finite, is earlier
    // than the last event (unless it is a mirror), or has another radius or mass. An exception, of f too, leaves the
    // run as it was.
    template <class F>
    void restate(F f) {
        std::vector<state> others;
        others.reserve(scene().balls());
        for (body a = 0; a < scene().balls(); ++a) {
            others.push_back(f(scene().name(a), scene()[a].state));
        }
        give(std::move(others));
    }

    // Counts time from `by` on: `since` of every ball becomes since - by, and limits and events are on that clock from
    // now on. Small times are rounded more finely, so a long run stays as fine as at its start if its clock is set back
    // whenever it reaches twice `by`. Nothing else changes. Returns false, and leaves the run as it was, where a since
    // would not be exact (in general as long as some ball has had no event in the later half), and while some events of
    // the present time are done and others are not: try again some events later.
    [[nodiscard]] bool set_clock_back(const number& by) requires mechanics_of_clocks<M>;

  private:
    using body = detail::body;
    using listener = detail::listener<run_event<M>>;

    [[nodiscard]] const detail::moving_scene<M>& scene() const noexcept { return forecast_.scene(); }

    outcome go_on(const run_limits<number>& limits, listener observer);
    void give(std::vector<state> others);
    void predict_anew();
    [[nodiscard]] outcome ended_by(const detail::jammed_bodies& jam, outcome& done) const;
    void stop(const detail::jammed_bodies& jam, outcome& done);
    ending take_earliest(double until);
    bool perform(listener observer);

    detail::forecast<M> forecast_;
    std::vector<body> place_; // of a ball, by the scene's index
    detail::jam_watch jams_;
    std::vector<detail::timed_event<time>> simultaneous_; // events of one time
    std::size_t next_ = 0;                                // of simultaneous_
    detail::grazed_balls<M> grazed_;                      // at that time
    double now_ = 0;                                      // not after any event to come
    double still_until_ = std::numeric_limits<double>::lowest();
    std::uint64_t still_ = 0; // events since time last went on for certain
};

// The rest is defined outside the class, so that it is not inline: graze::compiled has it.

template <mechanics M>
run<M>::run(const graze::scene<dimension, number>& s, M m, cells use)
    : forecast_(detail::moving_scene<M>(s, std::move(m)), use == cells::where_useful), place_(s.balls.size()),
      jams_(scene().balls()) {
    for (body a = 0; a < scene().balls(); ++a) {
        place_[static_cast<std::size_t>(scene().name(a))] = a;
    }
    forecast_.predict_all(now_);
}

template <mechanics M>
outcome run<M>::go_on(const run_limits<number>& limits, listener observer) {
    const double until = detail::end_of(rules(), limits.time);
    outcome done{ending::events};
    const std::uint64_t patience = limits.cascade != 0 ? limits.cascade : 1000 + 100 * std::uint64_t{scene().balls()};
    while (done.events < limits.events) {
        if (next_ == simultaneous_.size()) {
            if (const ending found = take_earliest(until); found != ending::events) {
                done.why = found;
                return done;
            }
        }
        const detail::timed_event<time>& d = simultaneous_[next_];
        if (!grazed_.leave(scene(), d.what)) { // an event of the same time has changed one of the two
            ++next_;
            continue;
        }
        if (limits.time && detail::is_after(scene(), d, *limits.time)) {
            done.why = ending::time;
            return done;
        }
        const body a = d.what.a, b = d.what.b;
        if (const time_bounds bounds = scene().rules().bounds(d.when); bounds.lower > still_until_) {
            still_until_ = bounds.upper;
            still_ = 0;
        }
        if (scene()[a].stopped || (b < scene().balls() && scene()[b].stopped)) {
            return ended_by({a, b, detail::no_body, detail::no_body, detail::no_body}, done);
        }
        if (still_ >= patience) {
            const body stuck = scene()[a].immovable && b < scene().balls() ? b : a;
            if (!limits.stop_jams) {
                return ended_by(jams_.around(stuck), done);
            }
            stop(jams_.around(stuck), done);
            continue;
        }
        done.choices += d.chosen ? 1 : 0;
        const bool goes_on = perform(observer);
        ++done.events;
        if (!goes_on) {
            done.why = ending::stopped;
            return done;
        }
        if (const body stuck = detail::jammed(scene(), jams_, a, b, now_, limits.jam != 0 ? limits.jam : 10000);
            stuck != detail::no_body) {
            if (!limits.stop_jams) {
                return ended_by(jams_.around(stuck), done);
            }
            stop(jams_.around(stuck), done);
        }
    }
    return done;
}

template <mechanics M>
void run<M>::give(std::vector<state> others) {
    run changed(*this);
    for (body a = 0; a < scene().balls(); ++a) {
        state& other = others[a];
        if (const char* fault = detail::fault_of_state(scene(), a, other, detail::as_states_have<number>(now_))) {
            throw std::domain_error("ball " + std::to_string(scene().name(a)) + ": " + fault);
        }
        if (!scene()[a].immovable) {
            changed.now_ = std::min(changed.now_, scene().rules().about(other).since);
        }
        changed.forecast_.scene().restate(a, std::move(other));
    }
    changed.jams_ = detail::jam_watch(scene().balls());
    changed.predict_anew();
    *this = std::move(changed);
}

template <mechanics M>
bool run<M>::set_clock_back(const number& by) requires mechanics_of_clocks<M> {
    run changed(*this);
    if ((next_ != 0 && next_ != simultaneous_.size()) || !detail::set_clocks_back(changed.forecast_.scene(), by)) {
        return false;
    }
    const double about = detail::not_before<M>(rules(), by);
    changed.now_ = std::nextafter(now_ - about, std::numeric_limits<double>::lowest());
    changed.jams_.set_clock_back(about);
    changed.predict_anew();
    *this = std::move(changed);
    return true;
}

template <mechanics M>
void run<M>::predict_anew() {
    simultaneous_.clear();
    grazed_.clear();
    next_ = 0;
    still_ = 0;
    still_until_ = std::numeric_limits<double>::lowest();
    forecast_.predict_all(now_);
}

template <mechanics M>
outcome run<M>::ended_by(const detail::jammed_bodies& jam, outcome& done) const {
    detail::name_jam(scene(), jam, done);
    done.why = ending::cascade;
    return std::move(done);
}

// Stops those of the jam that can stop.
template <mechanics M>
void run<M>::stop(const detail::jammed_bodies& jam, outcome& done) {
    run changed(*this);
    detail::stop_jam(changed.forecast_, jam, now_);
    changed.still_ = 0;
    detail::name_jam(scene(), jam, done);
    *this = std::move(changed);
}

template <mechanics M>
ending run<M>::take_earliest(double until) {
    detail::keep_up_to_date(forecast_, detail::as_states_have<number>(now_)); // if it throws, nothing has changed
    next_ = 0;
    grazed_.clear();
    return forecast_.take_earliest(simultaneous_, until);
}

// Does the event simultaneous_[next_].
template <mechanics M>
bool run<M>::perform(listener observer) {
    const detail::timed_event<time>& d = simultaneous_[next_];
    const body a = d.what.a;
    const body b = d.what.b;
    const bool two = b < scene().balls();
    if (two && scene()[a].immovable && scene()[b].immovable) {
        detail::refuse_mirrors(scene(), d);
    }
    detail::moving_scene<M>& changing = forecast_.scene();
    auto before_a = changing.remember(a);
    auto before_b = changing.remember(two ? b : a);
    try {
        grazed_.take_back(changing, a, d.what.count_a);
        grazed_.take_back(changing, b, d.what.count_b);
        changing.bounce(a, b, d.what.image, d.when, !d.chosen);
        forecast_.note_place(a);
        forecast_.note_place(two ? b : a);
        forecast_.forget();
        const double now = scene().rules().bounds(d.when).lower;
        if (!two || !changing[a].immovable) {
            forecast_.predict(a, now);
        }
        if (two && !changing[b].immovable) {
            forecast_.predict(b, now);
        }
        forecast_.mark_choices(d.when, simultaneous_, next_ + 1);
        grazed_.note(changing, a, before_a);
        grazed_.note(changing, two ? b : a, before_b);
    } catch (...) {
        changing.restore(a, before_a);
        if (two) {
            changing.restore(b, before_b);
        }
        forecast_.note_place(a);
        forecast_.note_place(two ? b : a);
        throw;
    }
    forecast_.accept();
    now_ = scene().rules().bounds(d.when).lower;
    ++next_;
    ++still_;
    const run_event<M> told{scene().named(a, b),
                            d.when,
                            before_a.ball.state,
                            scene()[a].state,
                            two ? &before_b.ball.state : nullptr,
                            two ? &scene()[b].state : nullptr,
                            d.chosen};
    return observer(told);
}

} // namespace graze::inline v0_1
