// A scene's events one after the other: predict, take the earliest, let its two bounce, predict again. These members
// are not inline: graze::compiled has them.
#pragma once

#include <graze/run/run_declaration.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace graze::inline v0_1 {

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
void run<M>::give(detail::records<state> others) {
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
