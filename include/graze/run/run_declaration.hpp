// A scene's events one after the other: what a run offers. How it goes on is in run.hpp.
#pragma once

#include <graze/run/grazed_balls.hpp>
#include <graze/run/outcome.hpp>
#include <graze/run/run_steps.hpp>
#include <graze/scene/records.hpp>

#include <cstdint>
#include <limits>
#include <utility>

namespace graze::inline v0_1 {

// A run of a scene by mechanics M, from t = 0 on. Balls fly freely between their own events: only an event in which a
// ball takes part computes or rounds anything of it.
//
// Order. The earliest event is next, as M orders times. Events of exactly the same time that share no ball are all
// done. Of those that share one, which only M's rounding or a choice can tell apart, the first is done, in an order
// that depends on the scene's numbers alone, and the others are predicted again; after a graze, which changes no
// velocity, they happen as well. The run counts them (outcome::choices). Where M cannot tell the order of two events
// that share no ball, either is done first. The sequence and all states depend on the scene alone, not on the order
// of its lists; of two balls whose numbers are all the same, either may be called by the other's index.
//
// Rules. Two that have met are not offered to each other again until one of them has had another event. A point
// stays on the side of a plane or wall from which it came, wherever its position was rounded to. Balls that overlap
// and approach, at the start or later, are resolved at once along their line of centres; so is a ball that cuts a
// plane or wall and goes deeper. A ball of infinite mass is a mirror: nothing changes its flight. Nothing is lost:
// after an exception the run is as it was before the current event (after it, if the observer threw), and advance
// may be called again.
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
    // something, false stops the run. It must not call advance, restate or set_clock_back of this run. Throws
    // std::domain_error that names two balls of infinite mass that meet, or that says that the time limit is NaN, and
    // whatever M throws.
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
        detail::records<state> others;
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
    void give(detail::records<state> others);
    void predict_anew();
    [[nodiscard]] outcome ended_by(const detail::jammed_bodies& jam, outcome& done) const;
    void stop(const detail::jammed_bodies& jam, outcome& done);
    ending take_earliest(double until);
    bool perform(listener observer);

    detail::forecast<M> forecast_;
    detail::records<body> place_; // of a ball, by the scene's index
    detail::jam_watch jams_;
    detail::records<detail::timed_event<time>> simultaneous_;               // events of one time
    std::size_t next_ = 0;                                                  // of simultaneous_
    detail::grazed_balls<typename detail::moving_scene<M>::memory> grazed_; // at that time
    double now_ = 0;                                                        // not after any event to come
    double still_until_ = std::numeric_limits<double>::lowest();
    std::uint64_t still_ = 0; // events since time last went on for certain
};

} // namespace graze::inline v0_1
